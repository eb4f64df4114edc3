in vec4 vColour;
uniform float uOpacity;
out vec4 fragment;

void main()
{
    fragment = vec4(vColour.rgb, vColour.a * uOpacity);
}
