// Places from the depth of a picture, in world axes and relative to the eye.
uniform sampler2D uDepth;
uniform mat4 uBack; // clip space -> eye-relative

vec3 placeAt(ivec2 pixel)
{
    ivec2 size = textureSize(uDepth, 0);
    ivec2 inside = clamp(pixel, ivec2(0), size - 1);
    vec2 ndc = 2.0 * (vec2(inside) + 0.5) / vec2(size) - 1.0;
    vec4 place = uBack * vec4(ndc, 2.0 * texelFetch(uDepth, inside, 0).r - 1.0, 1.0);
    return place.xyz / place.w;
}
