// The mean of the pictures so far.
in vec2 ndc;
uniform sampler2D uPicture;
uniform float uShare; // of one of them
out vec4 fragment;

void main()
{
    vec4 sum = uShare * texelFetch(uPicture, ivec2(gl_FragCoord.xy), 0);
    fragment = vec4(toSrgb(sum.rgb), sum.a);
}
