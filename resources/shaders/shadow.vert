layout(location = 0) in vec3 aPosition;
// The depth pass and the shading pass must agree to the last bit.
invariant gl_Position;

uniform mat4 uClip;

void main()
{
    vec3 position = aPosition;
    vec3 normal = vec3(0.0);
    copied(position, normal);
    skin(position, normal);
    gl_Position = uClip * vec4(position, 1.0);
}
