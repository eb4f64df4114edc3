// What moves: bones lie in a texture, two texels each (rotation, translation), any number of them.
uniform sampler2D uBones;
uniform int uBoneCount;  // 0 = all at rest
uniform int uSkinMethod; // enum SkinMethod: 0 rigid, 1 linear blend, 2 dual quaternion

vec4 boneTexel(int index)
{
    int width = textureSize(uBones, 0).x;
    return texelFetch(uBones, ivec2(index % width, index / width), 0);
}

vec4 boneRotation(uint bone)
{
    return boneTexel(2 * int(bone));
}

vec3 boneTranslation(uint bone)
{
    return boneTexel(2 * int(bone) + 1).xyz;
}

vec3 turned(vec4 q, vec3 v)
{
    return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v);
}

vec4 product(vec4 a, vec4 b)
{
    return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
}

// A place on one branch, rigidly.
vec3 onBone(vec3 position, uint bone)
{
    if (bone >= uint(uBoneCount))
        return position;
    return turned(boneRotation(bone), position) + boneTranslation(bone);
}

mat3 rotationMatrix(vec4 q)
{
    return mat3(turned(q, vec3(1.0, 0.0, 0.0)), turned(q, vec3(0.0, 1.0, 0.0)), turned(q, vec3(0.0, 0.0, 1.0)));
}
