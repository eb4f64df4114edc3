// A line at a fixed distance from what is masked, darker towards the outside: seen on leaves and on the sky.
uniform sampler2D uDistance; // see outline_spread.frag
uniform vec2 uTexel;         // of the distances, per pixel of the picture
uniform bool uClosed;        // distances from what is far from the mask
uniform float uScale;        // pixels per texel
uniform float uOffset;       // pixels from the mask to the line's middle
uniform float uWidth;        // pixels
uniform float uOpacity;
out vec4 fragment;

const float reach = 4.0;
const vec3 ink = vec3(1.0, 0.50, 0.06);
const vec3 shade = vec3(0.16, 0.07, 0.0);

void main()
{
    // Distances from texels go by steps: the mean around the place does not.
    vec2 at = gl_FragCoord.xy * uTexel, aside = 0.7 * uScale * uTexel;
    float mean = 0.25 * (texture(uDistance, at + aside).r + texture(uDistance, at - aside).r +
                         texture(uDistance, at + vec2(aside.x, -aside.y)).r +
                         texture(uDistance, at + vec2(-aside.x, aside.y)).r);
    float away = mean * (reach + 1.0) * uScale;
    if (uClosed)
        away = 0.8 * (reach + 1.0) * uScale - away;
    float line = 1.0 - smoothstep(0.5 * uWidth - 0.5, 0.5 * uWidth + 0.5, abs(away - uOffset));
    float rim = 0.55 * (1.0 - smoothstep(0.5 * uWidth + 0.5, 0.5 * uWidth + 1.5, abs(away - uOffset)));
    float alpha = max(line, rim);
    if (alpha <= 0.0)
        discard;
    fragment = vec4(mix(shade, ink, line), uOpacity * alpha);
}
