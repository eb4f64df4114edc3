// One of many trees: its light is that of the corners, as in far.frag, its picture that of the pixel.
in vec3 colour; // sRGB, of the mean of the picture
in vec2 uv;
in vec2 shown; // how much of it is (crowd_choice.h), 0 .. 255; how much of the picture of bark

uniform int uImages; // 0 none; 1 uBark is a picture of any surface, 2 of bark
uniform bool uHasBark;
uniform sampler2D uBark; // sRGB; opacity, of bark occlusion
uniform vec3 uMean;      // sRGB, of the picture
uniform bool uCovers;
uniform float uFlat; // CrowdPart::flat

const float patches = 96.0;   // of light and shade in the crown on one picture, each way
const float patchiness = 0.6; // how much they differ

out vec4 fragment;

void main()
{
    vec4 own = uImages > 0 || uHasBark ? texture(uBark, uv) : vec4(uMean, 1.0);
    bool isCut = uImages == 1;
    float there = isCut ? own.a : 1.0;
    if (isCut && uCovers) // as in mesh.frag
        there = clamp((there - 0.5) / max(fwidth(there), 1e-4) + 0.5, 0.0, 1.0);
    vec3 detail = (isCut ? own.rgb : mix(uMean, own.rgb * (uHasBark ? own.a : 1.0), shown.y)) / max(uMean, vec3(0.02));
    if (uFlat > 0.0) { // as leaves that stand before each other
        vec2 at = floor(uv * patches);
        float lit = fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715))));
        float width = max(fwidth(uv.x), fwidth(uv.y)) * patches; // of a pixel
        detail *= 1.0 + patchiness * clamp(1.5 / max(width, 0.01), 0.0, 1.0) * (lit - 0.5);
    }
    // Where one form passes into the next each has some of the pixels.
    bool isSecond = shown.x > 127.5;
    bool isHere = isSecond ? 126.0 * pixelNoise() >= shown.x - 128.0 : 126.0 * pixelNoise() < shown.x;
    if (there < (uCovers ? 0.01 : 0.5) || (shown.x < 254.5 && !isHere))
        discard;
    fragment = vec4(dithered(colour * detail), uCovers ? there : 1.0);
}
