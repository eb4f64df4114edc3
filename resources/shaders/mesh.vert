layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in uint aBranch;
layout(location = 3) in vec2 aTexture;
layout(location = 4) in vec3 aColour; // sRGB, of the mesh ...
layout(location = 10) in vec3 aTint;  // ... and of its copy

// The depth pass and the shading pass must agree to the last bit.
invariant gl_Position;

uniform mat4 uClip;     // item -> clip space
uniform mat4 uRelative; // item -> world axes, relative to the eye
uniform mat3 uNormal;   // inverse transposed
uniform float uVariety; // how much leaves of different branches differ

out Surface
{
    vec3 relative;
    vec3 normal;
    vec3 own;
    vec4 tint;
    vec2 uv;
    float shade;
} v;

void main()
{
    vec3 position = aPosition;
    vec3 normal = aNormal;
    copied(position, normal);
    skin(position, normal);
    gl_Position = uClip * vec4(position, 1.0);
    v.relative = (uRelative * vec4(position, 1.0)).xyz;
    v.normal = uNormal * normal;
    v.own = aColour * aTint;
    // A branch's leaves are a little lighter or darker than its neighbour's: the crown gets depth.
    v.shade = 1.0 + uVariety * (fract(float(aBranch) * 0.6180340) - 0.5);
    v.uv = aTexture;
    v.tint = stateTint(branchState(aBranch));
}
