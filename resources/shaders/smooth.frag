// Anti-aliasing after the fact (Lottes 2009, FXAA): where the brightness has an edge, the colours are blended along it.
// Much cheaper than multisampling where the processor draws.
in vec2 ndc;
uniform sampler2D uPicture;
out vec4 fragment;

const float leastContrast = 1.0 / 24.0;
const float reach = 6.0; // pixels

float luma(vec3 c)
{
    return dot(c, vec3(0.299, 0.587, 0.114));
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(uPicture, 0) - 1;
    vec4 centre = texelFetch(uPicture, at, 0);
    float m = luma(centre.rgb);
    float nw = luma(texelFetch(uPicture, clamp(at + ivec2(-1, 1), ivec2(0), last), 0).rgb);
    float ne = luma(texelFetch(uPicture, clamp(at + ivec2(1, 1), ivec2(0), last), 0).rgb);
    float sw = luma(texelFetch(uPicture, clamp(at + ivec2(-1, -1), ivec2(0), last), 0).rgb);
    float se = luma(texelFetch(uPicture, clamp(at + ivec2(1, -1), ivec2(0), last), 0).rgb);
    float low = min(m, min(min(nw, ne), min(sw, se)));
    float high = max(m, max(max(nw, ne), max(sw, se)));
    if (high - low < max(leastContrast, 0.12 * high)) {
        fragment = centre;
        return;
    }
    vec2 along = vec2((sw + se) - (nw + ne), (nw + sw) - (ne + se));
    float damping = max((nw + ne + sw + se) * 0.03125, 1.0 / 128.0);
    along = clamp(along / (min(abs(along.x), abs(along.y)) + damping), -reach, reach);
    vec2 texel = 1.0 / vec2(last + 1);
    vec2 uv = gl_FragCoord.xy * texel;
    along *= texel;
    vec4 narrow = 0.5 * (texture(uPicture, uv - along / 6.0) + texture(uPicture, uv + along / 6.0));
    vec4 wide = 0.5 * narrow + 0.25 * (texture(uPicture, uv - 0.5 * along) + texture(uPicture, uv + 0.5 * along));
    float brightness = luma(wide.rgb);
    fragment = brightness < low || brightness > high ? narrow : wide;
}
