// Vertices of a mesh follow up to three bones: the same as Deformer on the processor.
layout(location = 5) in uvec3 aBones;
layout(location = 6) in vec3 aWeights;
layout(location = 7) in float aSlope; // weight that passes from the first bone to the second, per metre of rest Z

// Right for transforms that are not rigid any more.
mat3 cofactors(mat3 m)
{
    return mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
}

void mixLinear(inout vec3 position, inout vec3 normal)
{
    mat3 turn = mat3(0.0);
    vec3 shift = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        if (aWeights[i] <= 0.0)
            break;
        turn += aWeights[i] * rotationMatrix(boneRotation(aBones[i]));
        shift += aWeights[i] * boneTranslation(aBones[i]);
    }
    mat3 leaning = turn;
    if (aSlope != 0.0)
        leaning[2] += aSlope * (turned(boneRotation(aBones.y), position) + boneTranslation(aBones.y) -
                                turned(boneRotation(aBones.x), position) - boneTranslation(aBones.x));
    position = turn * position + shift;
    normal = cofactors(leaning) * normal;
}

vec4 conjugate(vec4 q)
{
    return vec4(-q.xyz, q.w);
}

void mixScrews(inout vec3 position, inout vec3 normal)
{
    vec4 pivot = boneRotation(aBones.x);
    vec4 real = vec4(0.0), dual = vec4(0.0), realTo = vec4(0.0), dualTo = vec4(0.0);
    for (int i = 0; i < 3; ++i) {
        if (aWeights[i] <= 0.0)
            break;
        vec4 q = boneRotation(aBones[i]);
        if (dot(q, pivot) < 0.0)
            q = -q;
        vec4 d = 0.5 * product(vec4(boneTranslation(aBones[i]), 0.0), q);
        real += aWeights[i] * q;
        dual += aWeights[i] * d;
        if (i < 2) {
            realTo += i == 0 ? -q : q;
            dualTo += i == 0 ? -d : d;
        }
    }
    float scale = inversesqrt(dot(real, real));
    real *= scale;
    dual *= scale;
    vec3 shift = 2.0 * product(dual, conjugate(real)).xyz;
    vec3 arm = turned(real, position);
    position = arm + shift;
    normal = turned(real, normal);
    if (aSlope == 0.0)
        return;
    // The derivative of the mean screw motion, as Deformer has it.
    float along = dot(real, realTo);
    vec4 turning = (realTo - along * real) * scale;
    vec4 shifting = (dualTo - along * dual) * scale;
    vec3 spin = 2.0 * product(turning, conjugate(real)).xyz;
    vec3 away = cross(spin, arm) +
                2.0 * (product(shifting, conjugate(real)) + product(dual, conjugate(turning))).xyz;
    // In the frame that was turned, only the axis of the rest mesh leans.
    vec3 axis = turned(real, vec3(0.0, 0.0, 1.0));
    mat3 leaning = mat3(1.0) + outerProduct(aSlope * away, axis);
    normal = cofactors(leaning) * normal;
}

void skin(inout vec3 position, inout vec3 normal)
{
#ifndef STILL
    if (uWindProfile != 0) {
        position = inWind(position, normal);
        return;
    }
    if (uBoneCount == 0)
        return;
    if (uSkinMethod == 0 || aWeights.y <= 0.0) {
        vec4 q = boneRotation(aBones.x);
        position = turned(q, position) + boneTranslation(aBones.x);
        normal = turned(q, normal);
    } else if (uSkinMethod == 1)
        mixLinear(position, normal);
    else
        mixScrews(position, normal);
#endif
}
