// The mean of four pixels a side, of those that lie on the same surface.
uniform sampler2D uSource;
uniform float uRadius; // m

out vec4 fragment;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 here = placeAt(pixel);
    float sum = 0.0, all = 0.0;
    for (int y = -2; y < 2; ++y)
        for (int x = -2; x < 2; ++x) {
            ivec2 beside = clamp(pixel + ivec2(x, y), ivec2(0), textureSize(uDepth, 0) - 1);
            float weight = max(1e-4, 1.0 - length(placeAt(beside) - here) / (0.5 * uRadius));
            sum += weight * texelFetch(uSource, beside, 0).r;
            all += weight;
        }
    fragment = vec4(sum / all);
}
