layout(location = 0) in vec3 aPosition;
layout(location = 1) in float aSize;
layout(location = 2) in vec4 aColour;
layout(location = 3) in uint aBranch;

uniform mat4 uClip;
uniform vec2 uViewport;
uniform float uPixelRatio;
uniform float uLift;

out vec4 vColour;
out vec2 vDisc;
flat out float vRadius; // pixels

void main()
{
    vec4 tint = stateTint(branchState(aBranch));
    vColour = vec4(mix(aColour.rgb, tint.rgb, tint.a), aColour.a);
    vRadius = 0.5 * aSize * uPixelRatio + 0.5;
    vDisc = vec2((gl_VertexID & 1) == 1 ? 1.0 : -1.0, (gl_VertexID & 2) == 2 ? 1.0 : -1.0);
    vec4 position = uClip * vec4(onBone(aPosition, aBranch), 1.0);
    position.xy += 2.0 * vDisc * vRadius / uViewport * position.w;
    position.z -= uLift * position.w;
    gl_Position = position;
}
