layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in uint aBranch;

// The depth pass and the shading pass must agree to the last bit.
invariant gl_Position;

uniform mat4 uClip;     // item -> clip space
uniform mat4 uRelative; // item -> world axes, relative to the eye
uniform mat3 uNormal;   // inverse transposed

out Surface
{
    vec3 relative;
    vec3 normal;
    vec3 local;
    vec4 tint;
} v;

void main()
{
    gl_Position = uClip * vec4(aPosition, 1.0);
    v.relative = (uRelative * vec4(aPosition, 1.0)).xyz;
    v.normal = uNormal * aNormal;
    v.local = aPosition;
    v.tint = stateTint(branchState(aBranch));
}
