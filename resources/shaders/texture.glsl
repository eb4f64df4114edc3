// Texture coordinates made visible: a checker, or how far a triangle's map is from one that keeps squares.
#ifdef BARK
const int uPaint = 0;
#else
uniform int uPaint; // enum Paint: 0 the material, 1 checker, 2 stretch, 3 weights
#endif

const vec3 lightSquare = vec3(0.95, 0.92, 0.85);
const vec3 darkSquare = vec3(0.30, 0.40, 0.55);
const vec3 mirroredColour = vec3(0.90, 0.0, 0.80);
const float smallestSquare = 7.0; // pixels

// Squares of side tiles, their edges as wide as a pixel. Box filter: A. Fournier's checker, as in iq's articles.
float squares(vec2 uv, vec2 width, float side)
{
    vec2 w = max(width / side, vec2(1e-6));
    vec2 p = uv / side;
    vec2 a = 2.0 * (abs(fract(0.5 * (p - 0.5 * w)) - 0.5) - abs(fract(0.5 * (p + 0.5 * w)) - 0.5)) / w;
    return 0.5 - 0.5 * a.x * a.y;
}

vec3 checker(vec2 uv)
{
    vec2 width = max(abs(dFdx(uv)) + abs(dFdy(uv)), vec2(1e-7));
    // Twice as large squares wherever the smaller ones would be too small, one fading into the other. Where a
    // surface turns away, squares of the same size show that it does.
    float pixelSize = max(min(length(dFdx(uv)), length(dFdy(uv))), 1e-7);
    float level = max(log2(smallestSquare * pixelSize), 0.0);
    float side = exp2(floor(level));
    float coarse = smoothstep(0.85, 1.0, fract(level));
    return mix(darkSquare, lightSquare, mix(squares(uv, width, side), squares(uv, width, 2.0 * side), coarse));
}

// The two singular values of the map from the surface to the texture, from what both do from pixel to pixel.
vec3 stretchColour(vec2 uv, vec3 place)
{
    vec3 across = dFdx(place);
    vec3 along = dFdy(place);
    vec2 du = dFdx(uv);
    vec2 dv = dFdy(uv);
    // A frame in the surface: the map's columns.
    float length1 = max(length(across), 1e-20);
    vec3 e1 = across / length1;
    float part = dot(along, e1);
    float length2 = max(length(along - part * e1), 1e-20);
    vec2 c1 = du / length1;
    vec2 c2 = (dv - c1 * part) / length2;
    float area = c1.x * c2.y - c1.y * c2.x;
    // Seen from outside, pixels run against the surface's frame or with it: dFdx x dFdy looks to the eye.
    if (!gl_FrontFacing)
        area = -area;
    if (area <= 0.0)
        return mirroredColour;
    float shape = 0.5 * (dot(c1, c1) + dot(c2, c2)) / area;
    float stretch = shape + sqrt(max(shape * shape - 1.0, 0.0));
    vec3 colour = mix(vec3(0.16, 0.35, 0.62), vec3(0.35, 0.66, 0.72), clamp((stretch - 1.0) / 0.12, 0.0, 1.0));
    colour = mix(colour, vec3(0.96, 0.93, 0.62), clamp((stretch - 1.12) / 0.13, 0.0, 1.0));
    colour = mix(colour, vec3(0.95, 0.55, 0.15), clamp((stretch - 1.25) / 0.25, 0.0, 1.0));
    return mix(colour, vec3(0.72, 0.08, 0.10), clamp((stretch - 1.5) / 0.5, 0.0, 1.0));
}

// sRGB
vec3 boneColour(float bone)
{
    vec3 hue = abs(fract(bone * 0.3819660 + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0;
    return mix(vec3(0.9), clamp(hue, 0.0, 1.0), 0.75);
}

vec3 painted(vec2 uv, vec3 place, vec3 material)
{
    if (uPaint == 3)
        return mix(boneColour(floor(uv.x)), boneColour(floor(uv.x) + 1.0), fract(uv.x));
    if (uPaint == 1)
        return checker(uv);
    if (uPaint == 2)
        return stretchColour(uv, place);
    return material;
}
