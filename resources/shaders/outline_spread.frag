// How far each texel of a picture is from what is masked in it, exactly and in two passes: along its row, then along
// its column (Saito and Toriwaki 1994). Distances up to "reach" texels, as a share of reach + 1.
//
// CLOSED: of such a picture what is far from the mask is the new mask. How far a texel is from that leaves gaps and holes
// out that are narrow, and is what else stays the same.
uniform sampler2D uSource; // ROWS: the depths of the mask, or with CLOSED distances; else what the first pass gave
out vec4 fragment;

const int reach = 4;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(uSource, 0) - 1;
    float nearest = float((reach + 1) * (reach + 1));
    for (int i = -reach; i <= reach; ++i) {
#ifdef ROWS
        float value = texelFetch(uSource, clamp(at + ivec2(i, 0), ivec2(0), last), 0).r;
#ifdef CLOSED
        bool isMasked = value > 0.8;
#else
        bool isMasked = value < 1.0;
#endif
        float across = isMasked ? 0.0 : float(reach + 1);
#else
        float across = texelFetch(uSource, clamp(at + ivec2(0, i), ivec2(0), last), 0).r * float(reach + 1);
#endif
        nearest = min(nearest, across * across + float(i * i));
    }
    fragment = vec4(sqrt(nearest) / float(reach + 1));
}
