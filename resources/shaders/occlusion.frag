// How much of the sky's light reaches a place past what stands close by: McGuire, Mara and Luebke, "Scalable ambient
// obscurance", HPG 2012, its sum over a disc around each pixel, in units of the disc's radius.
uniform float uRadius;   // m
uniform vec4 uPixels;    // xyz the way to the eye; w pixels a metre has at distance 1, or everywhere where uParallel
uniform bool uParallel;

out vec4 fragment;

const int count = 16;
const float strength = 0.35;
const float bias = 0.04; // against planes that hide themselves
const float widest = 0.12; // of the picture's height
const float golden = 2.3999632;

// The nearer of two neighbours lies on the same surface.
vec3 along(vec3 here, ivec2 pixel, ivec2 step)
{
    vec3 ahead = placeAt(pixel + step) - here, behind = here - placeAt(pixel - step);
    return dot(ahead, ahead) < dot(behind, behind) ? ahead : behind;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    fragment = vec4(1.0);
    if (texelFetch(uDepth, pixel, 0).r >= 1.0)
        return;
    vec3 here = placeAt(pixel);
    float pixels = uRadius * uPixels.w / (uParallel ? 1.0 : max(dot(-here, uPixels.xyz), 1e-6));
    if (pixels < 1.5)
        return;
    float reach = min(pixels, widest * float(textureSize(uDepth, 0).y));
    float radius = uRadius * reach / pixels;
    vec3 normal = cross(along(here, pixel, ivec2(1, 0)), along(here, pixel, ivec2(0, 1)));
    normal /= max(length(normal), 1e-20);
    // Sixteen turns, each once in any square of four pixels a side: what blurs it takes the mean of them all.
    float turn = 6.2831853 / 16.0 * float((pixel.x & 3) * 4 + ((pixel.x + pixel.y) & 3));
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        float share = (float(i) + 0.5) / float(count);
        float angle = float(i) * golden + turn;
        ivec2 beside = pixel + ivec2(round(share * reach * vec2(cos(angle), sin(angle))));
        vec3 way = (placeAt(beside) - here) / radius;
        float square = dot(way, way);
        // What lies behind the farthest plane has no place of its own.
        float near = texelFetch(uDepth, clamp(beside, ivec2(0), textureSize(uDepth, 0) - 1), 0).r < 1.0 ? max(1.0 - square, 0.0) : 0.0;
        sum += near * near * near * max(dot(way, normal) - bias, 0.0) / (square + 0.01);
    }
    fragment = vec4(max(0.0, 1.0 - strength * 5.0 / float(count) * sum));
}
