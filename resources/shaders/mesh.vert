layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in uint aBranch;
layout(location = 3) in vec2 aTexture;
layout(location = 4) in vec3 aColour; // sRGB, of the mesh ...
layout(location = 10) in vec4 aTint;  // ... and of its copy; of a crowd: how much of it is shown (crowd_choice.h)
layout(location = 12) in float aRadius; // m, of the wood there

// The depth pass and the shading pass must agree to the last bit.
invariant gl_Position;

uniform mat4 uClip;     // item -> clip space
uniform mat4 uRelative; // item -> world axes, relative to the eye
uniform mat3 uNormal;   // inverse transposed
uniform float uVariety; // how much leaves of different branches differ
// m: radii up to which bark is young, and from which it is not; up to which it is that of limbs, and from which it is old
uniform vec4 uYouth;
uniform bool uWeathers;

#ifdef FAR
uniform vec3 uColour; // sRGB

out vec3 colour; // sRGB
#ifdef CROWD
uniform bool uHasBark;
uniform vec3 uYoung; // as in mesh.frag
uniform vec3 uLimb;
uniform vec3 uMean; // sRGB, of the pictures
uniform float uFlat; // CrowdPart::flat

out vec2 uv;
out vec2 shown; // how much of it is; how much of the picture of bark
#endif
#else
out Surface
{
    vec3 relative;
    vec3 normal;
    vec3 own;
    vec4 tint;
    vec2 uv;
    float shade;
    vec3 age; // 0 the skin of twigs, 1 bark; 0 that of limbs, 1 of old trunks; 0 clean, 1 weathered
} v;
#endif

#ifndef FAR
float latticeShare(ivec3 at, uint seed)
{
    uint h = seed + uint(at.z) * 0x27D4EB2Fu + uint(at.x) * 0x8DA6B343u + uint(at.y) * 0xD8163841u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return float((h ^ (h >> 15)) >> 8) / 16777216.0;
}

float latticeNoise(vec3 at, uint seed)
{
    ivec3 base = ivec3(floor(at));
    vec3 f = at - vec3(base), s = f * f * (3.0 - 2.0 * f);
    vec4 low, high;
    for (int i = 0; i < 4; ++i) {
        ivec3 corner = base + ivec3(0, i & 1, i >> 1);
        low[i] = latticeShare(corner, seed);
        high[i] = latticeShare(corner + ivec3(1, 0, 0), seed);
    }
    vec4 across = mix(low, high, s.x);
    return mix(mix(across.x, across.y, s.y), mix(across.z, across.w, s.y), s.z);
}

// barkWeather() of bark_maps.cpp
float weather(vec3 place)
{
    vec3 at = clamp(place, -1e4, 1e4) * vec3(1.7, 0.8, 1.7);
    return smoothstep(0.35, 0.8, 0.65 * latticeNoise(at, 1u) + 0.35 * latticeNoise(2.7 * at, 2u));
}
#endif

void main()
{
    vec3 position = aPosition;
    vec3 normal = aNormal;
    copied(position, normal);
    skin(position, normal);
    gl_Position = uClip * vec4(position, 1.0);
    vec3 relative = (uRelative * vec4(position, 1.0)).xyz;
    normal = uNormal * normal;
    vec3 own = aColour * aTint.rgb;
    vec4 tint = stateTint(branchState(aBranch));
    // A branch's leaves are a little lighter or darker than its neighbour's: the crown gets depth.
    float shade = 1.0 + uVariety * (fract(float(aBranch) * 0.6180340) - 0.5);
#ifdef FAR // so small that its light is that of its corners
    normal = normalize(normal);
    if (uTwoSided && dot(normal, toEye(relative)) < 0.0)
        normal = -normal;
    own *= uColour;
#ifdef CROWD
    crownAt = (uCrownPlace * vec4(aPosition, 1.0)).xyz;
    crownTurn = aTurn;
    if (uFlat > 0.0) { // one picture of all: its light is that of the side which is seen
        vec3 eye = mat3(uCrownPlace) * turned(vec4(-aTurn.xyz, aTurn.w), toEye(relative));
        crownAt = mix(vec3(0.5), crownAt, uFlat) + 0.3 * normalize(eye);
    }
    uv = aTexture;
    shown = vec2(255.0 * aTint.a, 1.0);
    if (uHasBark) {
        vec2 ages = smoothstep(log(uYouth.xz), log(uYouth.yw), vec2(log(max(aRadius, 1e-6))));
        own = mix(uYoung.r < 0.0 ? uMean : uYoung, uMean * mix(uLimb, vec3(1.0), ages.y), ages.x);
        shown.y = ages.x;
    } else
        own *= uMean;
#endif
    vec3 albedo = toLinear(mix(own, tint.rgb, tint.a)) * shade;
    colour = toSrgb(shaded(relative, albedo, normal, normal, 1.0));
#else
    v.relative = relative;
    v.normal = normal;
    v.own = own;
    v.tint = tint;
    v.uv = aTexture;
    v.shade = shade;
    vec2 ages = smoothstep(log(uYouth.xz), log(uYouth.yw), vec2(log(max(aRadius, 1e-6))));
    v.age = vec3(ages, uWeathers ? weather(aPosition) : 0.0);
#endif
}
