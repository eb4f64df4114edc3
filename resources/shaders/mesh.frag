in Surface
{
    vec3 relative;
    vec3 normal;
    vec3 own; // sRGB, tinted by uColour
    vec4 tint;
    vec2 uv;
    float shade;
    vec3 age; // of the skin of twigs, of the bark of limbs; weather: 0 .. 1
} v;
#ifdef WIRE
noperspective in vec3 edgeDistance;
uniform bool uWireOnly;
uniform float uLineWidth; // pixels
#endif

uniform vec3 uColour;      // sRGB
uniform float uOpacity;
uniform bool uCovers; // what a picture cuts out covers some of a pixel's samples

#ifdef SURFACES
layout(location = 0) out vec4 fragment; // their own colour, sRGB
layout(location = 1) out vec4 surface;  // normal, depth

uniform vec2 uDepth; // what turns metres before the eye into 0 for the farthest, 1 for the nearest: sum, factor
#else
out vec4 fragment;
#endif

#ifdef COLOURS
uniform bool uHasColours; // each triangle has its own, tinted by uColour
uniform sampler2D uColours;
#endif

// Reading gl_PrimitiveID has its price: softpipe draws nothing where no geometry shader writes it.
vec3 ownColour()
{
#ifdef COLOURS
    int width = textureSize(uColours, 0).x;
    if (uHasColours)
        return uColour * texelFetch(uColours, ivec2(gl_PrimitiveID % width, gl_PrimitiveID / width), 0).rgb;
#endif
    return uColour * v.own;
}

#ifdef BARK // known before: software rasterisers run both ways of a branch, and pictures are what costs most
const bool uHasBark = BARK;
const bool uVeins = VEINS;
const int uImages = 0;
#else
uniform bool uHasBark;
uniform bool uVeins;
uniform int uImages; // 0 none; 1 uBark and uBarkNormals are pictures of any surface, 2 of bark
#endif
uniform sampler2D uBark;        // sRGB, occlusion
uniform sampler2D uBarkNormals; // tangent space, roughness
uniform vec3 uYoung;            // sRGB, of thin wood; below 0: the mean of uBark
uniform vec3 uLimb;             // what uBark is multiplied by on limbs
uniform float uGrey;            // of uBark on average

const vec3 weatheredBark = vec3(0.70, 0.74, 0.68); // bark_maps.h

// The bark's colour, its normal turned by what stands out of it. The frame of the texture comes from what both do from
// pixel to pixel (Schueler, "Followup: normal mapping without precomputed tangents", 2013).
vec3 barkColour(inout vec3 normal)
{
    vec3 across = dFdx(v.relative), along = dFdy(v.relative);
    vec2 du = dFdx(v.uv), dv = dFdy(v.uv);
    vec3 p = cross(along, normal), q = cross(normal, across);
    vec3 t = p * du.x + q * dv.x, b = p * du.y + q * dv.y;
    // Bark is as old as the branch is thick.
    vec4 old = texture(uBark, v.uv);
    vec3 bark = old.rgb * old.a * mix(uLimb, vec3(1.0), v.age.y);
    // Skin has a grain, too: a little of what the bark will be.
    vec3 young = uYoung.r < 0.0 ? textureLod(uBark, v.uv, 20.0).rgb
                                : uYoung * mix(1.0, dot(old.rgb, vec3(0.3333)) * old.a / uGrey, 0.35);
    vec3 relief = texture(uBarkNormals, v.uv).xyz * 2.0 - 1.0;
    float scale = inversesqrt(max(max(dot(t, t), dot(b, b)), 1e-30));
    normal = normalize(max(v.age.x, 0.3) * scale * (t * relief.x + b * relief.y) + normal * max(relief.z, 0.1));
    return mix(young, bark, v.age.x) * (1.0 - v.age.z * (1.0 - weatheredBark));
}

uniform vec3 uBlade; // sRGB, of the leaf whose picture uBark is where uVeins, or what pictures replace

vec3 leafColour(inout vec3 normal)
{
    vec3 across = dFdx(v.relative), along = dFdy(v.relative);
    vec2 du = dFdx(v.uv), dv = dFdy(v.uv);
    vec3 p = cross(along, normal), q = cross(normal, across);
    vec3 t = p * du.x + q * dv.x, b = p * du.y + q * dv.y;
    vec3 relief = texture(uBarkNormals, v.uv).xyz * 2.0 - 1.0;
    float scale = inversesqrt(max(max(dot(t, t), dot(b, b)), 1e-30));
    normal = normalize(scale * (t * relief.x + b * relief.y) + normal * max(relief.z, 0.1));
    return ownColour() * texture(uBark, v.uv).rgb / max(uBlade, vec3(0.02));
}

void main()
{
    vec3 plane = cross(dFdx(v.relative), dFdy(v.relative));
    plane /= max(length(plane), 1e-18);
    vec3 normal = dot(v.normal, v.normal) > 1e-8 ? normalize(v.normal) : gl_FrontFacing ? plane : -plane;
    vec3 own = uVeins || uImages == 1 ? leafColour(normal)
               : uImages == 2         ? ownColour() / max(uBlade, vec3(0.02)) * barkColour(normal)
               : uHasBark             ? barkColour(normal)
                                      : ownColour();
    float gloss = uImages > 0 ? 2.0 * (1.0 - texture(uBarkNormals, v.uv).a) : 1.0; // of pictures, roughness
    bool isCut = uImages == 1 && uPaint == 0;
    float there = isCut ? texture(uBark, v.uv).a : 1.0;
    if (isCut && uCovers) // an edge as wide as a pixel (Golus, "Anti-aliased alpha test", 2017)
        there = clamp((there - 0.5) / max(fwidth(there), 1e-4) + 0.5, 0.0, 1.0);
    vec3 paint = painted(v.uv, v.relative, own);
    vec3 albedo = toLinear(mix(paint, v.tint.rgb, v.tint.a)) * v.shade;
    if (!gl_FrontFacing) {
        normal = -normal;
        // The inside of a surface that should be closed looks dull: holes are seen.
        if (!uTwoSided)
            albedo = mix(albedo, vec3(dot(albedo, vec3(0.3333))), 0.6) * 0.5;
    }
    if (isCut && there < (uCovers ? 0.01 : 0.5)) // after everything that looks at its neighbours
        discard;
#ifdef SURFACES
    float depth = clamp((dot(v.relative, uBackward.xyz) + uDepth.x) * uDepth.y, 0.0, 1.0);
    normal -= 2.0 * min(dot(normal, uBackward.xyz), 0.0) * uBackward.xyz; // what is seen looks to the eye
    fragment = vec4(toSrgb(albedo), 1.0);
    surface = vec4(0.5 + 0.5 * normal, (1.0 + 254.0 * depth) / 255.0);
#elif defined(WIRE)
    float edge = min(min(edgeDistance.x, edgeDistance.y), edgeDistance.z);
    float line = 1.0 - smoothstep(0.5 * uLineWidth - 0.5, 0.5 * uLineWidth + 0.5, edge);
    if (uWireOnly) {
        if (line < 0.4)
            discard;
        fragment = vec4(dithered(toSrgb(mix(albedo * 0.35, albedo, v.tint.a))), uOpacity);
        return;
    }
    vec3 colour = shaded(v.relative, albedo, normal, plane, gloss);
    fragment = vec4(dithered(toSrgb(mix(colour, albedo * 0.06, 0.75 * line))), uOpacity);
#else
    fragment = vec4(dithered(toSrgb(shaded(v.relative, albedo, normal, plane, gloss))), uCovers ? there : uOpacity);
#endif
}
