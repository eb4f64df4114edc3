// Vertices of a mesh follow up to three bones: the same as Deformer on the processor.
layout(location = 5) in uvec3 aBones;
layout(location = 6) in vec3 aWeights;

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
    position = turn * position + shift;
    // Cofactors: right for transforms that are not rigid any more.
    normal = mat3(cross(turn[1], turn[2]), cross(turn[2], turn[0]), cross(turn[0], turn[1])) * normal;
}

void mixScrews(inout vec3 position, inout vec3 normal)
{
    vec4 pivot = boneRotation(aBones.x);
    vec4 real = vec4(0.0), dual = vec4(0.0);
    for (int i = 0; i < 3; ++i) {
        if (aWeights[i] <= 0.0)
            break;
        vec4 q = boneRotation(aBones[i]);
        float weight = dot(q, pivot) < 0.0 ? -aWeights[i] : aWeights[i];
        real += weight * q;
        dual += 0.5 * weight * product(vec4(boneTranslation(aBones[i]), 0.0), q);
    }
    float scale = inversesqrt(dot(real, real));
    real *= scale;
    dual *= scale;
    vec3 shift = 2.0 * product(dual, vec4(-real.xyz, real.w)).xyz;
    position = turned(real, position) + shift;
    normal = turned(real, normal);
}

void skin(inout vec3 position, inout vec3 normal)
{
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
}
