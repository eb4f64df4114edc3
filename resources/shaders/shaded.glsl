// How a surface looks in the light. Places are relative to the eye, colours linear.
uniform float uShininess;  // 0 = Lambert
uniform float uGlint;      // strength of the highlight
uniform float uThrough;    // share of the light that shines through, for leaves
uniform vec3 uSheen;       // of what they throw back, what never was inside them
uniform vec3 uPassed;      // what shines through, of the rest
uniform bool uTwoSided;
uniform vec4 uBackward;    // orthographic: direction to the eye, w = 1; perspective: w = 0
uniform float uAround;   // share of the light from all around that leaves let through as they do the sun's
uniform float uStanding; // more light for surfaces that stand: beside a ground that shows its colour a trunk is dark

uniform bool uHasCrown;
uniform mat4 uCrownPlace; // eye-relative -> the crown's grid
uniform sampler3D uCrown; // the way out, share of the sky that is seen

#ifdef CROWD // where a corner is in the crown of its own tree, and how that is turned
vec3 crownAt;
vec4 crownTurn;
const vec2 crownSun = vec2(0.55, 0.45); // of the sun's light what reaches a place that sees all of the sky; the same by its side
#endif

const float roundness = 0.5;  // of a crown's leaves: they look the way out as much
const float innermost = 0.4; // of the sky's light, what leaves pass on to the middle of a thick crown
const float passedOn = 1.4;  // of the light that a leaf throws back or lets through, what meets others in a thick crown

vec3 toEye(vec3 relative)
{
    return uBackward.w > 0.5 ? uBackward.xyz : normalize(-relative);
}

vec3 shaded(vec3 relative, vec3 albedo, vec3 normal, vec3 plane, float gloss)
{
    float facing = dot(normal, uSun);
    vec3 side = uTwoSided ? plane : normal;
    float sun = sunlight(relative, dot(side, uSun) < 0.0 ? -side : side, plane);
    float open = uThrough > 0.0 ? 1.0 : skyReaching(); // a crown's light knows already what leaves hide
    float hidden = 0.0;
    vec3 round = normal;
    if (uHasCrown) {
#ifdef CROWD
        vec4 crown = textureLod(uCrown, crownAt, 0.0);
        vec3 outwards = turned(crownTurn, 2.0 * crown.xyz - 1.0);
#else
        vec4 crown = texture(uCrown, (uCrownPlace * vec4(relative, 1.0)).xyz);
        vec3 outwards = 2.0 * crown.xyz - 1.0;
#endif
        hidden = 1.0 - crown.a;
#ifdef CROWD // cards are too few to shade each other as leaves do
        sun *= clamp(crown.a * (crownSun.x + crownSun.y * dot(outwards, uSun)), 0.0, 1.0);
#endif
        open *= mix(innermost, 1.0, crown.a);
        if (uThrough > 0.0)
            round = normalize(mix(normal, outwards, roundness) + 1e-4 * normal);
    }
    vec3 light = open * ambient(round) + uSunLight * max(dot(round, uSun), 0.0) * sun;
    vec3 colour = albedo * light;
    if (uThrough > 0.0) {
        vec3 behind = max(-facing, 0.0) * sun * uSunLight + uAround * open * ambient(-round);
        vec3 through = uThrough * uPassed * max(albedo - uSheen, 0.0);
        colour += through * behind;
        colour *= 1.0 + passedOn * hidden * (albedo + through);
    }
    if (uShininess > 0.0) {
        float glint = pow(max(dot(reflect(-uSun, normal), toEye(relative)), 0.0), uShininess);
        colour += step(0.0, facing) * sun * glint * gloss * uGlint * uSunLight;
    }
    return uPaint == 0 ? exposed(uStanding * colour) : uStanding * colour;
}
