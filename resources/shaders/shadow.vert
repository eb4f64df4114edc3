layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal; // along which leaves flutter
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
    vec3 normal = aNormal;
    copied(position, normal);
    skin(position, normal);
#ifdef CUT
    uv = aTexture;
#endif
    gl_Position = uClip * vec4(position, 1.0);
}
