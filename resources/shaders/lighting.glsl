// Sun with a soft shadow, and light from all around. Positions are relative to the eye.
uniform vec3 uSun;         // unit, towards the sun
uniform vec3 uSunLight;    // linear
uniform vec3 uAmbient[9];  // linear, by the way a surface faces: see sky.h
uniform float uExposure;   // 0: light is shown as it is
uniform vec3 uGain;
uniform int uShadowTaps;   // 0 = no shadows
// One map of everything; in pictures at rest one more of what the view shows near.
uniform mat4 uShadow;      // eye-relative position -> shadow map coordinates and depth, 0..1
uniform vec3 uShadowScale; // size of one texel (m), side of the map (m), depth range (m)
uniform sampler2DShadow uShadowMap;
uniform sampler2D uShadowDepth;
#ifdef ONE_SHADOW
const bool uHasNear = false;
#else
uniform bool uHasNear;
#endif
uniform mat4 uNear;
uniform vec3 uNearScale;
uniform sampler2DShadow uNearMap;
uniform sampler2D uNearDepth;

const mat2 golden = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888); // turns by the golden angle
uniform float uSunSpread; // width of the penumbra per metre behind the edge

// The next point of a disc of count points, the i-th; each lies a golden angle further than the one before.
vec2 discPoint(int i, int count, inout vec2 way)
{
    way = golden * way;
    return sqrt((float(i) + 0.5) / float(count)) * way;
}

// How fast the depth of a plane grows over the map (Isidoro 2006, receiver plane depth bias): what is read beside a
// place is compared with the plane there, so that a surface the sun grazes does not shade itself.
vec2 depthSlope(mat4 place, vec3 scale, vec3 plane)
{
    const float steepest = 6.0; // m per metre
    vec2 across = scale.y * vec2(dot(plane, vec3(place[0][0], place[1][0], place[2][0])),
                                 dot(plane, vec3(place[0][1], place[1][1], place[2][1])));
    float towards = dot(plane, uSun);
    across /= (towards < 0.0 ? -1.0 : 1.0) * max(abs(towards), length(across) / steepest + 1e-6);
    return across * scale.y / scale.z;
}

// Fernando 2005, percentage-closer soft shadows: the farther behind its blocker, the softer.
float kernelRadius(sampler2D depths, vec3 scale, vec3 at, vec2 slope, float texel, vec2 way)
{
    float widest = clamp(scale.z * uSunSpread / scale.y, 2.0 * texel, 14.0 * texel);
    float sum = 0.0;
    float count = 0.0;
    int taps = min(uShadowTaps, 8); // not a constant: processors leave a loop that no pixel needs
    for (int i = 0; i < taps; ++i) {
        vec2 beside = i == 0 ? vec2(0.0) : widest * discPoint(i, taps, way); // nothing so near is missed by any
        float gap = at.z + dot(slope, beside) - texture(depths, at.xy + beside).r;
        if (gap > 0.0) {
            sum += gap;
            count += 1.0;
        }
    }
    if (count == 0.0)
        return 0.0;
    float gap = sum / count * scale.z;
    return clamp(gap * uSunSpread / scale.y, 1.0 * texel, widest);
}

// Where a place lies in a map: lifted off the surface by as much as the map is coarse.
vec3 mapped(mat4 place, vec3 scale, vec3 relative, vec3 normal)
{
    float steepness = 1.0 - max(dot(normal, uSun), 0.0);
    relative += normal * scale.x * (0.6 + 1.6 * steepness) + uSun * scale.x * 0.8;
    vec3 at = (place * vec4(relative, 1.0)).xyz;
    return vec3(at.xy, min(at.z, 1.0));
}

float lit(sampler2DShadow map, sampler2D depths, mat4 place, vec3 scale, vec3 at, vec3 plane)
{
#ifdef FAR // the light of a few pixels
    return textureLod(map, at, 0.0);
#else
    vec2 slope = depthSlope(place, scale, plane);
    float texel = scale.x / scale.y;
    vec2 way = vec2(1.0, 0.0);
    float radius = 1.8 * texel;
    if (uShadowTaps >= 12) {
        float turn = 6.2831853 * pixelNoise();
        way = vec2(cos(turn), sin(turn));
        radius = kernelRadius(depths, scale, at, slope, texel, way);
        if (radius == 0.0)
            return 1.0;
    }
    float sum = 0.0;
    for (int i = 0; i < uShadowTaps; ++i) {
        vec2 beside = radius * discPoint(i, uShadowTaps, way);
        sum += texture(map, vec3(at.xy + beside, at.z + dot(slope, beside)));
    }
    return sum / float(uShadowTaps);
#endif
}

// 1 in the sun, 0 in the shadow. The normal faces the sun's side; the plane is that of the surface itself.
float sunlight(vec3 relative, vec3 normal, vec3 plane)
{
    if (uShadowTaps == 0)
        return 1.0;
    float far = 1.0; // share that the map of everything has
    float sum = 0.0;
    if (uHasNear) {
        vec3 at = mapped(uNear, uNearScale, relative, normal);
        vec2 inside = 0.5 - abs(at.xy - 0.5);
        float near = smoothstep(0.0, 0.08, min(inside.x, inside.y)); // one passes into the other
        if (near > 0.0)
            sum += near * lit(uNearMap, uNearDepth, uNear, uNearScale, at, plane);
        far -= near;
    }
    if (far <= 0.0)
        return sum;
    vec3 at = mapped(uShadow, uShadowScale, relative, normal);
    bool outside = any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0)));
    return sum + far * (outside ? 1.0 : lit(uShadowMap, uShadowDepth, uShadow, uShadowScale, at, plane));
}

vec3 ambient(vec3 n)
{
    vec3 sum = uAmbient[0] + n.y * uAmbient[1] + n.z * uAmbient[2] + n.x * uAmbient[3];
    sum += n.x * n.y * uAmbient[4] + n.y * n.z * uAmbient[5] + (3.0 * n.y * n.y - 1.0) * uAmbient[6];
    return max(sum + n.x * n.z * uAmbient[7] + (n.z * n.z - n.x * n.x) * uAmbient[8], vec3(0.0));
}

// Narkowicz 2015, a fit of the Academy's curve: contrast in the middle, soft highlights. Taken colour by colour it makes
// greens of leaves gaudy.
vec3 film(vec3 c)
{
    c = c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
    return mix(vec3(dot(c, vec3(0.2126, 0.7152, 0.0722))), c, 0.8);
}

vec3 exposed(vec3 light)
{
    return uExposure > 0.0 ? film(uExposure * uGain * light) : uGain * light;
}
