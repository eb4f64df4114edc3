// A tree in the wind of a game: what shaders of the engine do with the numbers that an export writes for it
// (core/game_wind/wind_profile.h), before a file rounds them. All is in the tree's space, m.
//
// - Plain, ours: sway and flutter are sine waves.
// - Crysis: T. Sousa, "Vegetation Procedural Animation and Shading in Crysis", GPU Gems 3, chapter 16,
//   listings 1 and 2, detail before main bending; speed and frequency 1, no phase of the object.
// - Unity: AnimateVertex of TerrainEngine.cginc, for _Wind = (s d, s); no phase of the object.
// - Pivot Painter 2: PivotPainter2FoliageShader of the Unreal Engine, with sine waves for its texture of gusts.
//   It adds up what each piece of a chain does by itself.
layout(location = 11) in vec3 aWind; // phase (0 to 1); m of sway; number of the piece

uniform int uWindProfile;    // enum WindProfile; 0: none
uniform vec2 uWindDirection; // unit, X and Z
uniform vec2 uWindNow;       // strength, 1 is a strong wind; s
uniform vec4 uWindTree;      // m: its base; 1/m: lean by the square of the height; 1/m: Crysis' bendScale; flutter of a leaf's edge by its way from the petiole
uniform sampler2D uElements; // two texels a piece: where it turns, and its parent; its axis, and extent
uniform vec4 uTurns;         // of PivotMotion: by depth
uniform vec4 uGusts;         // offset, falloff, speed, across
uniform vec3 uShelter;       // m until gusts come again; bias, scale

const float wholeTurn = 6.283185307179586;

float smoothTriangleWave(float x)
{
    float triangle = abs(fract(x + 0.5) * 2.0 - 1.0);
    return triangle * triangle * (3.0 - 2.0 * triangle);
}

float waves(float at, vec2 rates)
{
    vec2 turns = fract(at * rates) * 2.0 - 1.0;
    return smoothTriangleWave(turns.x) + smoothTriangleWave(turns.y);
}

float edgeWaves(float at)
{
    return waves(at, vec2(1.975, 0.793));
}

float branchWaves(float at)
{
    return waves(at, vec2(0.375, 0.193));
}

vec4 elementTexel(int index)
{
    int width = textureSize(uElements, 0).x;
    return texelFetch(uElements, ivec2(index % width, index / width), 0);
}

// By one piece, of a place of its own or of what stands on it.
vec3 pushedBy(int element, int depth, vec3 wind, vec3 place)
{
    vec3 pivot = elementTexel(2 * element).xyz;
    vec4 reach = elementTexel(2 * element + 1);
    vec3 axis = reach.xyz, p = place - pivot, tip = pivot + reach.w * axis;
    float along = dot(wind, axis), ahead = max(0.0, along);
    vec2 at = uWindNow.y * uGusts.zw + vec2(dot(wind, tip), dot(vec3(-wind.z, 0.0, wind.x), tip)) / uShelter.x;
    float gust = 0.5 + 0.25 * (sin(wholeTurn * at.x) + sin(wholeTurn * at.y));
    float share = clamp(dot(p, axis) / (uGusts.y * reach.w), 0.0, 1.0);
    float angle = wholeTurn * uWindNow.x * uTurns[depth] * (uGusts.x + gust) * (along + uShelter.y) * uShelter.z * share;
    vec3 about = cross(axis, wind - vec3(0.0, 0.2 * ahead * ahead * ahead * ahead * ahead, 0.0));
    if (length(about) < 1e-3) // against the wind: neither way
        return vec3(0.0);
    vec3 unit = normalize(about), from = p - dot(unit, p) * unit;
    return cos(angle) * from + sin(angle) * cross(unit, from) - from;
}

vec3 pivotPainter(vec3 wind, vec3 place)
{
    int own = int(aWind.z), depth = 0;
    for (int at = own, up = int(elementTexel(2 * at).w); up != at; at = up, up = int(elementTexel(2 * at).w))
        ++depth;
    vec3 offset = vec3(0.0);
    for (int at = own; depth >= 0; --depth, at = int(elementTexel(2 * at).w))
        offset += pushedBy(at, depth, wind, place);
    return place + offset;
}

vec3 crysis(vec3 wind, vec3 place, vec3 normal, float flutter)
{
    float edge = edgeWaves(uWindNow.y + (place.x + place.y - place.z) * aWind.x);
    float branch = branchWaves(uWindNow.y + aWind.x);
    vec3 p = place + uWindNow.x * vec3(edge * flutter * normal.x, branch * aWind.y, edge * flutter * normal.z);
    float bend = 1.0 + p.y * uWindTree.z, squared = bend * bend;
    vec3 bent = p + (squared * squared - squared) * uWindNow.x * wind;
    return length(bent) > 0.0 ? bent * (length(p) / length(bent)) : p;
}

vec3 unity(vec3 wind, vec3 place, vec3 normal, float lean, float flutter)
{
    const float detailAmp = 0.1, branchAmp = 0.3;
    float edges = min(flutter / detailAmp, 1.0);
    float edge = edgeWaves(uWindNow.y + (place.y + place.z - place.x) * (edges + aWind.x));
    float branch = branchWaves(uWindNow.y + aWind.x);
    vec3 detail = vec3(edge * edges * detailAmp * normal.x, branch * aWind.y * branchAmp, edge * edges * detailAmp * normal.z);
    vec3 blown = uWindNow.x * wind;
    return place + uWindNow.x * (detail + branch * aWind.y * blown) + lean * blown;
}

vec3 inWind(vec3 place, vec3 normal)
{
    vec3 wind = vec3(uWindDirection.x, 0.0, uWindDirection.y);
    float up = max(0.0, place.y - uWindTree.x), lean = uWindTree.y * up * up;
    float flutter = uWindTree.w * distance(place, aPlace.xyz);
    if (uWindProfile == 2)
        return crysis(wind, place, normal, flutter);
    if (uWindProfile == 3)
        return unity(wind, place, normal, lean, flutter);
    if (uWindProfile == 4)
        return pivotPainter(wind, place);
    float sway = lean + aWind.y * sin(wholeTurn * (0.5 * uWindNow.y + aWind.x));
    return place + uWindNow.x * (sway * wind + flutter * sin(wholeTurn * (2.0 * uWindNow.y + aWind.x)) * normal);
}
