// One triangle over the whole picture.
out vec2 ndc;

#ifdef LEVEL
uniform vec3 uPlaneDepth; // of a plane seen in perspective, by (ndc x, ndc y, 1)
#endif

void main()
{
    ndc = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
#ifdef LEVEL
    gl_Position = vec4(ndc, dot(uPlaneDepth, vec3(ndc, 1.0)), 1.0);
#else
    gl_Position = vec4(ndc, 1.0, 1.0);
#endif
}
