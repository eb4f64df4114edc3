layout(location = 0) in vec3 aPosition;
// The depth pass and the shading pass must agree to the last bit.
invariant gl_Position;

uniform mat4 uClip;

void main()
{
    gl_Position = uClip * vec4(aPosition, 1.0);
}
