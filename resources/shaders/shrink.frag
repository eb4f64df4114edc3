// A picture drawn twice as large each way: the mean of four pixels each, which linear filtering gives between them.
in vec2 ndc;
uniform sampler2D uPicture;
out vec4 fragment;

void main()
{
    fragment = texture(uPicture, 0.5 * ndc + 0.5);
}
