in vec3 colour; // sRGB

uniform float uOpacity;

out vec4 fragment;

void main()
{
    fragment = vec4(dithered(colour), uOpacity);
}
