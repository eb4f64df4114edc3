layout(location = 0) in vec3 aPosition;
#ifdef CUT // out of a picture: what is not there throws no shadow
layout(location = 3) in vec2 aTexture;
out vec2 uv;
#endif
// The depth pass and the shading pass must agree to the last bit.
invariant gl_Position;

uniform mat4 uClip;

void main()
{
    vec3 position = aPosition;
    vec3 normal = vec3(0.0);
    copied(position, normal);
    skin(position, normal);
#ifdef CUT
    uv = aTexture;
#endif
    gl_Position = uClip * vec4(position, 1.0);
}
