// One mesh stands in many places: leaves and apples. What is no copy reads the attributes' rest, which changes nothing.
layout(location = 8) in vec4 aPlace; // where, and its size
layout(location = 9) in vec4 aTurn;  // a quaternion

void copied(inout vec3 position, inout vec3 normal)
{
    position = turned(aTurn, aPlace.w * position) + aPlace.xyz;
    normal = turned(aTurn, normal);
}
