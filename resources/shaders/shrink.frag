// A picture drawn twice as large each way: the mean of four pixels each. Light adds up, the numbers of sRGB do not; of
// what is seen through, the colour counts as far as it covers.
in vec2 ndc;
uniform sampler2D uPicture;
out vec4 fragment;

void main()
{
    ivec2 at = 2 * ivec2(gl_FragCoord.xy);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec4 part = texelFetch(uPicture, at + ivec2(i & 1, i >> 1), 0);
        sum += vec4(toLinear(part.rgb) * part.a, part.a);
    }
    fragment = vec4(toSrgb(sum.rgb / max(sum.a, 1e-4)), 0.25 * sum.a);
}
