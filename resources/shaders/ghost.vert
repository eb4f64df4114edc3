layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;

uniform mat4 uClip;     // item -> clip space
uniform mat4 uRelative; // item -> world axes, relative to the eye
uniform mat3 uNormal;   // inverse transposed

out vec3 vRelative;
out vec3 vNormal;

void main()
{
    gl_Position = uClip * vec4(aPosition, 1.0);
    vRelative = (uRelative * vec4(aPosition, 1.0)).xyz;
    vNormal = uNormal * aNormal;
}
