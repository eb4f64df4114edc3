// What a fragment knows of its pixel.
// Interleaved gradient noise (Jimenez 2014): even over any 3 x 3 pixels.
float pixelNoise()
{
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

// Breaks up the bands of slow gradients; less than one step of eight bits.
vec3 dithered(vec3 srgb)
{
    return srgb + (pixelNoise() - 0.5) / 255.0;
}

uniform sampler2D uOcclusion; // over the whole picture: what stands close by hides of the sky
uniform vec2 uOcclusionScale; // per pixel; 0: nothing does

float skyReaching()
{
    return uOcclusionScale.x > 0.0 ? texture(uOcclusion, gl_FragCoord.xy * uOcclusionScale).r : 1.0;
}
