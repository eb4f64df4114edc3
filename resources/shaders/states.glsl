// The state of each branch (enum BranchState) lies in a texture: a selection uploads one byte per branch.
uniform usampler2D uStates;
uniform int uStateCount; // 0 = none

const vec3 selectedColour = vec3(1.0, 0.50, 0.06);
const vec3 activeColour = vec3(1.0, 0.72, 0.22);
const vec3 hoveredColour = vec3(1.0, 0.93, 0.78);
const vec3 goesColour = vec3(0.92, 0.13, 0.10); // what a tool would take away

uint branchState(uint branch)
{
#ifdef UNMARKED
    return 0u;
#else
    if (branch >= uint(uStateCount))
        return 0u;
    int width = textureSize(uStates, 0).x;
    return texelFetch(uStates, ivec2(int(branch) % width, int(branch) / width), 0).r;
#endif
}

// sRGB colour and strength.
vec4 stateTint(uint state)
{
    if (state == 1u)
        return vec4(selectedColour, 0.72);
    if (state == 2u)
        return vec4(activeColour, 0.80);
    if (state == 3u)
        return vec4(hoveredColour, 0.38);
    if (state == 4u)
        return vec4(mix(selectedColour, hoveredColour, 0.45), 0.80);
    if (state == 5u)
        return vec4(goesColour, 0.75);
    return vec4(0.0);
}
