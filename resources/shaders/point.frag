in vec4 vColour;
in vec2 vDisc;
flat in float vRadius;
uniform float uOpacity;
out vec4 fragment;

void main()
{
    float fromEdge = (1.0 - length(vDisc)) * vRadius;
    float cover = clamp(fromEdge, 0.0, 1.0);
    if (cover <= 0.0)
        discard;
    // A thin dark rim keeps the mark visible on any background.
    vec3 colour = mix(vColour.rgb * 0.35, vColour.rgb, clamp(fromEdge - 1.0, 0.0, 1.0));
    fragment = vec4(colour, vColour.a * uOpacity * cover);
}
