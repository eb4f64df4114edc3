// Adds to each corner its distance in pixels from the three edges, for an even wireframe in one pass.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform vec2 uViewport; // pixels

in Surface
{
    vec3 relative;
    vec3 normal;
    vec3 own;
    vec4 tint;
    vec2 uv;
    float shade;
    vec3 age;
} vIn[];

out Surface
{
    vec3 relative;
    vec3 normal;
    vec3 own;
    vec4 tint;
    vec2 uv;
    float shade;
    vec3 age;
} v;
noperspective out vec3 edgeDistance;

void main()
{
    vec2 p[3];
    bool behind = false;
    for (int i = 0; i < 3; ++i) {
        behind = behind || gl_in[i].gl_Position.w <= 0.0;
        p[i] = 0.5 * uViewport * gl_in[i].gl_Position.xy / max(gl_in[i].gl_Position.w, 1e-9);
    }
    float area = abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y));
    for (int i = 0; i < 3; ++i) {
        gl_Position = gl_in[i].gl_Position;
        gl_PrimitiveID = gl_PrimitiveIDIn;
        v.relative = vIn[i].relative;
        v.normal = vIn[i].normal;
        v.own = vIn[i].own;
        v.tint = vIn[i].tint;
        v.uv = vIn[i].uv;
        v.shade = vIn[i].shade;
        v.age = vIn[i].age;
        edgeDistance = vec3(behind ? 1e6 : 0.0);
        if (!behind)
            edgeDistance[i] = area / max(length(p[(i + 1) % 3] - p[(i + 2) % 3]), 1e-6);
        EmitVertex();
    }
    EndPrimitive();
}
