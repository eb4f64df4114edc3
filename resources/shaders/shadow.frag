#ifdef CUT
in vec2 uv;
uniform sampler2D uBark; // sRGB, opacity

void main()
{
    if (texture(uBark, uv).a < 0.5)
        discard;
}
#else
void main() {}
#endif
