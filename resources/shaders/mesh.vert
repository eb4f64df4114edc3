layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in uint aBranch;
layout(location = 3) in vec2 aTexture;
layout(location = 4) in vec3 aColour; // sRGB, of the mesh ...
layout(location = 10) in vec3 aTint;  // ... and of its copy
layout(location = 12) in float aRadius; // m, of the wood there

// The depth pass and the shading pass must agree to the last bit.
invariant gl_Position;

uniform mat4 uClip;     // item -> clip space
uniform mat4 uRelative; // item -> world axes, relative to the eye
uniform mat3 uNormal;   // inverse transposed
uniform float uVariety; // how much leaves of different branches differ
uniform vec2 uYouth;    // m: radii up to which bark is young, and from which it is old

#ifdef FAR
uniform vec3 uColour; // sRGB

out vec3 colour; // sRGB
#else
out Surface
{
    vec3 relative;
    vec3 normal;
    vec3 own;
    vec4 tint;
    vec2 uv;
    float shade;
    float age; // 0 the skin of twigs, 1 bark
} v;
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
    vec3 own = aColour * aTint;
    vec4 tint = stateTint(branchState(aBranch));
    // A branch's leaves are a little lighter or darker than its neighbour's: the crown gets depth.
    float shade = 1.0 + uVariety * (fract(float(aBranch) * 0.6180340) - 0.5);
#ifdef FAR // so small that its light is that of its corners
    normal = normalize(normal);
    if (uTwoSided && dot(normal, toEye(relative)) < 0.0)
        normal = -normal;
    own *= uColour;
    vec3 albedo = toLinear(mix(own, tint.rgb, tint.a)) * shade;
    colour = toSrgb(shaded(relative, albedo, normal, normal, 1.0));
#else
    v.relative = relative;
    v.normal = normal;
    v.own = own;
    v.tint = tint;
    v.uv = aTexture;
    v.shade = shade;
    v.age = smoothstep(log(uYouth.x), log(uYouth.y), log(max(aRadius, 1e-6)));
#endif
}
