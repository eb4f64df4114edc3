// How far each texel of a picture is from what is masked in it, exactly and in two passes: along its row, then along
// its column (Saito and Toriwaki 1994). Distances up to "reach" texels, as a share of reach + 1.
uniform sampler2D uSource; // ROWS: the depths of the mask; else what the first pass gave
out vec4 fragment;

const int reach = 4;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(uSource, 0) - 1;
    float nearest = float((reach + 1) * (reach + 1));
    for (int i = -reach; i <= reach; ++i) {
#ifdef ROWS
        float across = texelFetch(uSource, clamp(at + ivec2(i, 0), ivec2(0), last), 0).r < 1.0 ? 0.0 : float(reach + 1);
#else
        float across = texelFetch(uSource, clamp(at + ivec2(0, i), ivec2(0), last), 0).r * float(reach + 1);
#endif
        nearest = min(nearest, across * across + float(i * i));
    }
    fragment = vec4(sqrt(nearest) / float(reach + 1));
}
