Shader "Ramure/Tree"
{
    Properties
    {
        _MainTex ("Colour", 2D) = "white" {}
        _BumpMap ("Normals", 2D) = "bump" {}
        _Color ("Tint", Color) = (1, 1, 1, 1)
        _Cutoff ("Cut out below", Range(0, 1)) = 0
        _Glossiness ("Smoothness", Range(0, 1)) = 0.1
    }
    SubShader
    {
        Tags { "RenderType" = "TransparentCutout" "Queue" = "AlphaTest" }
        Cull Off
        CGPROGRAM
        #pragma surface surf Standard vertex:vert addshadow fullforwardshadows
        #pragma target 3.0
        #include "RamureWind.hlsl"

        sampler2D _MainTex, _BumpMap;
        fixed4 _Color;
        half _Cutoff, _Glossiness;
        float4 _RamureWind;

        struct Input
        {
            float2 uv_MainTex;
        };

        void vert(inout appdata_full v)
        {
            float3 moved;
            RamureWind_float(v.vertex.xyz, v.normal, v.color, v.texcoord1.xy, _RamureWind, _Time.y, moved);
            v.vertex.xyz = moved;
        }

        void surf(Input IN, inout SurfaceOutputStandard o)
        {
            fixed4 colour = tex2D(_MainTex, IN.uv_MainTex) * _Color;
            clip(colour.a - _Cutoff);
            o.Albedo = colour.rgb;
            o.Normal = UnpackNormal(tex2D(_BumpMap, IN.uv_MainTex));
            o.Smoothness = _Glossiness;
        }
        ENDCG
    }
    FallBack "Diffuse"
}
