// Sky and ground of SPEC A10. The ground is a level plane, met by a ray per pixel: it reaches the horizon and never
// runs out of triangles or of depth.
in vec2 ndc;

uniform vec3 uForward; // of the rays
uniform vec3 uAcross;  // added per ndc x ...
uniform vec3 uAlong;   // ... and y: to the direction, or in orthographic views to the origin
#ifdef LEVEL // in perspective and with ground, whose depth is that of the triangle
const bool uOrthographic = false;
const bool uGroundShown = true;
#else
uniform bool uOrthographic;
uniform bool uGroundShown; // else only its grid is, and what lies below can be seen
#endif
#ifdef MEADOW
const bool uSky = false;
const vec3 uStudio = vec3(-1.0);
#else
uniform vec3 uStudio; // sRGB; one colour instead of sky and meadow; below 0: none
uniform bool uSky;    // the sky of a clear day, Preetham et al. 1999: see sky.h
#endif
uniform vec3 uEye;         // world
uniform float uGround;     // height of the plane, m
uniform vec2 uCentre;      // of the scene, x and z
uniform float uFade;       // distance at which the ground melts into the sky, m
uniform float uGridStep;   // 0 = no grid
uniform float uPixelRatio;  // device pixels per logical one
uniform float uMottle;     // size of the ground's patches, m
uniform int uFeetCount;    // trunks that stand on roots
uniform vec3 uFeet[16];    // x, z and how far their roots reach, m
uniform mat4 uClip;        // eye-relative -> clip space
uniform vec3 uPerezA, uPerezB, uPerezC, uPerezD, uPerezE, uSkyScale; // of Y, x and y

out vec4 fragment;

const vec3 skyBlue = vec3(0.5294, 0.8078, 0.9216);    // #87CEEB
const vec3 groundGreen = vec3(0.3373, 0.4902, 0.2745); // #567D46
const vec3 haze = vec3(0.7961, 0.9098, 0.9529);

#ifdef PICTURE
uniform sampler2D uPicture; // all around, from the zenith down; the east in the middle
uniform float uPictureTurn, uPictureScale;

vec3 clearSky(vec3 direction)
{
    const float turn = 6.2831853;
    float across = atan(-direction.z, -direction.x) / turn - uPictureTurn;
    float lowest = uGroundShown ? 0.003 : -1.0; // the ground melts into the picture's horizon
    float down = 0.5 - asin(clamp(direction.y, lowest, 1.0)) / (0.5 * turn);
    return uPictureScale * textureLod(uPicture, vec2(across, down), 0.0).rgb;
}
#else
vec3 clearSky(vec3 direction)
{
    float along = dot(direction, uSun);
    vec3 f = uSkyScale * (1.0 + uPerezA * exp(uPerezB / max(direction.y, 0.01))) *
             (1.0 + uPerezC * exp(uPerezD * acos(clamp(along, -1.0, 1.0))) + uPerezE * along * along);
    f.z = max(f.z, f.y * (2.870 - 3.000 * f.y) - 0.275); // of daylight
    vec3 cie = f.x * vec3(f.y, f.z, 1.0 - f.y - f.z) / f.z;
    vec3 colour = vec3(0.906, 1.013, 1.215) * max(cie * mat3(3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570), vec3(0.0));
    return colour + 8.0 * uSunLight * smoothstep(0.99994, 0.99999, along); // 0.27 degrees to the sun's rim
}
#endif

vec3 sky(vec3 direction)
{
    vec3 colour = mix(haze, skyBlue, smoothstep(0.0, 0.30, direction.y));
    colour = mix(colour, vec3(0.69, 0.80, 0.83), smoothstep(0.0, -0.5, direction.y));
    float glow = pow(max(dot(direction, uSun), 0.0), 220.0);
    return mix(colour, vec3(1.0, 0.98, 0.92), 0.75 * glow);
}

float hash(vec2 cell)
{
    vec3 p = fract(vec3(cell.xyx) * 0.1031);
    p += dot(p, p.yzx + 33.33);
    return fract((p.x + p.y) * p.z);
}

float noise(vec2 at)
{
    vec2 cell = floor(at);
    vec2 f = at - cell;
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(cell), hash(cell + vec2(1.0, 0.0)), f.x),
               mix(hash(cell + vec2(0.0, 1.0)), hash(cell + vec2(1.0, 1.0)), f.x), f.y);
}

// Coverage of lines every "spacing" metres, one pixel wide; dense ones dissolve before they shimmer.
float gridLines(vec2 at, vec2 width, float spacing)
{
    vec2 distance = abs(fract(at / spacing - 0.5) - 0.5) * spacing;
    vec2 line = (1.0 - smoothstep(0.5 * width, 1.5 * width, distance)) *
                (1.0 - smoothstep(0.15 * spacing, 0.45 * spacing, width));
    return max(line.x, line.y);
}

// Patches of so many metres, 0 .. 1; those under a pixel dissolve.
float patches(vec2 at, float size, float broad)
{
    return mix(noise(at / size), 0.5, smoothstep(0.2, 0.7, broad / size));
}

// Fallen leaves and bare earth between the roots of trees, out to where grass gets light and water.
vec3 littered(vec3 albedo, vec2 at, float broad)
{
    float bare = 0.0;
    for (int i = 0; i < uFeetCount; ++i)
        bare = max(bare, 2.2 - distance(at, uFeet[i].xy) / uFeet[i].z);
    if (bare <= 0.0)
        return albedo;
    float leaves = patches(at, 0.05, broad), crumbs = patches(at.yx, 0.013, broad), tufts = patches(at, 0.23, broad);
    vec3 litter = mix(vec3(0.055, 0.038, 0.021), vec3(0.165, 0.105, 0.050), leaves) * (0.7 + 0.6 * crumbs);
    return mix(albedo, litter, 0.9 * smoothstep(0.1, 1.0, bare + 0.8 * (tufts - 0.5) + 0.5 * (leaves - 0.5)));
}

// What a meadow's colour is multiplied by, 1 on average: dry and lush patches, and tufts as far as they are seen.
vec3 grass(vec2 at, float broad)
{
    float dry = patches(at, 2.6, broad) + 0.6 * patches(at.yx + 31.0, 0.83, broad) - 0.8;
    float tufts = patches(at, 0.16, broad) + 0.8 * patches(at.yx, 0.045, broad) - 0.9;
    return (1.0 + 0.55 * tufts) * (1.0 + dry * vec3(0.38, 0.14, -0.04));
}

vec3 ground(vec3 relative, vec2 at, vec2 width)
{
    const vec3 up = vec3(0.0, 1.0, 0.0);
    if (uStudio.r >= 0.0) { // in full light exactly the colour behind it: there is no horizon
        const vec3 eye = vec3(0.2126, 0.7152, 0.0722); // brightness alone: shadows are grey
        float shaded = dot(eye, ambient(up)) / dot(eye, ambient(up) + uSunLight * uSun.y);
        return toLinear(uStudio) * mix(shaded * skyReaching(), 1.0, sunlight(relative, up, up));
    }
    float broad = max(width.x, width.y);
    float mottle = (noise(at / uMottle) - 0.5) * (1.0 - smoothstep(0.2, 0.7, broad / uMottle));
    float fine = uMottle * 0.11;
    mottle += 0.7 * (noise(at / fine) - 0.5) * (1.0 - smoothstep(0.2, 0.7, broad / fine));
    vec3 albedo = toLinear(groundGreen) * (1.0 + 0.14 * mottle);
    if (uFeetCount > 0)
        albedo *= grass(at, 0.35 * broad + 0.65 * min(width.x, width.y));
    albedo = littered(albedo, at, broad);
    float sun = sunlight(relative, up, up);
    return albedo * (skyReaching() * ambient(up) + uSunLight * uSun.y * sun);
}

// Lines over the ground, or where it is not shown in the air; "strength" is how much of the pixel they take.
vec3 grid(vec3 colour, vec2 at, vec2 width, out float strength)
{
    float minor = gridLines(at, width, uGridStep);
    float major = gridLines(at, width, 10.0 * uGridStep);
    vec2 axis = 1.0 - smoothstep(0.7 * width, 1.9 * width, abs(at));
    strength = max(max(minor, major), max(axis.x, axis.y));
    float dark = uGroundShown && uStudio.r < 0.5 ? 1.0 : 0.0;
    colour = mix(colour, mix(vec3(0.30), vec3(0.75), dark), mix(0.20, 0.10, dark) * minor);
    colour = mix(colour, mix(vec3(0.22), vec3(0.85), dark), mix(0.30, 0.16, dark) * major);
    colour = mix(colour, vec3(0.55, 0.05, 0.05), 0.7 * axis.y);
    return mix(colour, vec3(0.04, 0.12, 0.60), 0.7 * axis.x);
}

void main()
{
    vec3 offset = uOrthographic ? ndc.x * uAcross + ndc.y * uAlong : vec3(0.0);
    vec3 direction = normalize(uOrthographic ? uForward : uForward + ndc.x * uAcross + ndc.y * uAlong);
    float height = uEye.y + offset.y - uGround;
    // In orthographic views the sky must not change with the pixel's ray, all of which are parallel.
    vec3 colour = uSky && !uOrthographic
                      ? clearSky(direction)
                      : toLinear(uStudio.r >= 0.0 ? uStudio
                                 : uOrthographic  ? mix(haze, skyBlue, clamp(0.5 + 0.5 * ndc.y, 0.0, 1.0))
                                                  : sky(direction));
    float depth = 1.0;

    float steps = height / max(-direction.y, 1e-5);
    vec3 relative = offset + direction * clamp(steps, 0.0, 400.0 * uFade);
    vec2 at = uEye.xz + relative.xz;
    vec2 width = uPixelRatio * fwidth(at);
    if (direction.y < -1e-5 && height > 0.0) {
        float far = length(at - uCentre) / uFade;
        float melt = 1.0 - exp(-pow(far, 1.7));
        float strength = 0.0;
        if (melt < 0.998) {
            vec3 level = uGroundShown ? ground(relative, at, width) : colour;
            if (uGridStep > 0.0)
                level = grid(level, at, width, strength);
            colour = mix(level, colour, melt);
        }
        vec4 clip = uClip * vec4(relative, 1.0);
        if (uGroundShown || strength > 0.4)
            depth = clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0);
    } else if (uStudio.r < 0.0 && uGroundShown && uOrthographic && height < 0.0 && abs(direction.y) <= 1e-5) {
        colour = mix(toLinear(groundGreen), colour, 1.0 - exp(2.0 * height / uFade));
    }
#ifndef LEVEL
    gl_FragDepth = depth;
#endif
#ifdef DEPTH_ONLY // what makes the colour falls away
    fragment = vec4(0.0);
#else
    if (uStudio.r < 0.0)
        colour = uSky ? exposed(colour) : uGain * colour;
    fragment = vec4(dithered(toSrgb(colour)), 1.0);
#endif
}
