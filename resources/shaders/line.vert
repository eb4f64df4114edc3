// Each line is a quad that faces the screen: an even width in pixels, at any density of the display.
layout(location = 0) in vec3 aFrom;
layout(location = 1) in vec3 aTo;
layout(location = 2) in vec2 aWidths;
layout(location = 3) in vec4 aColour;
layout(location = 4) in uint aBranch;

uniform mat4 uClip;
uniform vec2 uViewport; // pixels
uniform float uPixelRatio;
uniform bool uOnlySelected; // the others have no width
uniform float uLift; // share of the depth by which lines come forward

out vec4 vColour;

void main()
{
    vec4 from = uClip * vec4(onBone(aFrom, aBranch), 1.0);
    vec4 to = uClip * vec4(onBone(aTo, aBranch), 1.0);
    // Cut at the near plane: a point behind the eye has no place on the screen.
    float nearFrom = from.z + from.w;
    float nearTo = to.z + to.w;
    if (nearFrom < 0.0 && nearTo > 0.0)
        from = mix(from, to, nearFrom / (nearFrom - nearTo));
    else if (nearTo < 0.0 && nearFrom > 0.0)
        to = mix(to, from, nearTo / (nearTo - nearFrom));

    bool end = (gl_VertexID & 1) == 1;
    float side = (gl_VertexID & 2) == 2 ? 0.5 : -0.5;
    vec2 along = (to.xy / to.w - from.xy / from.w) * uViewport;
    along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);

    uint state = branchState(aBranch);
    vec4 tint = stateTint(state);
    float width = (end ? aWidths.y : aWidths.x) * (state == 0u ? 1.0 : 1.7);
    if (uOnlySelected && (state == 0u || state == 3u || state == 5u))
        width = 0.0;
    vColour = vec4(mix(aColour.rgb, tint.rgb, tint.a), aColour.a);

    vec4 position = end ? to : from;
    vec2 across = vec2(-along.y, along.x) * side * width * uPixelRatio;
    position.xy += 2.0 * across / uViewport * position.w;
    position.z -= uLift * position.w;
    gl_Position = position;
}
