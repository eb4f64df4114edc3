in vec3 vRelative;
in vec3 vNormal;

uniform vec4 uColour;   // sRGB, alpha
uniform vec4 uBackward; // orthographic: direction to the eye, w = 1; perspective: w = 0

out vec4 fragment;

void main()
{
    // Denser towards the rim, as glass is: the shape is read although there is no light on it.
    vec3 toEye = uBackward.w > 0.5 ? uBackward.xyz : normalize(-vRelative);
    vec3 normal = dot(vNormal, vNormal) > 1e-8 ? normalize(vNormal) : toEye;
    float rim = 1.0 - abs(dot(normal, toEye));
    fragment = vec4(uColour.rgb * (0.78 + 0.22 * normal.y), uColour.a * mix(0.7, 1.0, rim));
}
