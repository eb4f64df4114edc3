// One picture through a point of the lens, as light: light adds up, the numbers of sRGB do not.
in vec2 ndc;
uniform sampler2D uPicture;
out vec4 fragment;

void main()
{
    vec4 picture = texelFetch(uPicture, ivec2(gl_FragCoord.xy), 0);
    fragment = vec4(toLinear(picture.rgb), picture.a);
}
