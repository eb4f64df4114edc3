// In the place of pixel.glsl and texture.glsl where light is computed at the corners of triangles.
const int uPaint = 0;

float pixelNoise()
{
    return fract(0.6180340 * float(gl_VertexID + gl_InstanceID));
}

float skyReaching()
{
    return 1.0;
}
