// Wind for a tree of Ramure: AnimateVertex of Unity's TerrainEngine.cginc, without its tables. All in the tree's space, m.
// Custom Function node: RamureWind, inputs Position, Normal, Color, UV1, Wind (x, z: direction; w: strength), Time.
#ifndef RAMURE_WIND
#define RAMURE_WIND

float2 RamureWaves(float2 x)
{
    float2 both = abs(frac(frac(x) * 2.0 - 0.5) * 2.0 - 1.0);
    return both * both * (3.0 - 2.0 * both);
}

void RamureWind_float(float3 Position, float3 Normal, float4 Color, float2 UV1, float4 Wind, float Time, out float3 Out)
{
    const float detailAmp = 0.1, branchAmp = 0.3;
    float3 blown = Wind.w * float3(Wind.x, 0.0, Wind.z);
    float2 edges = RamureWaves((Time + dot(Position, float3(-1.0, 1.0, 1.0)) * (Color.g + Color.r)) * float2(1.975, 0.793));
    float2 limbs = RamureWaves((Time + Color.r) * float2(0.375, 0.193));
    float edge = (edges.x + edges.y) * Color.g * detailAmp, branch = limbs.x + limbs.y;
    float3 moved = float3(edge * Normal.x, branch * UV1.y * branchAmp, edge * Normal.z);
    Out = Position + Wind.w * (moved + branch * UV1.y * blown) + UV1.x * blown;
}

#endif
