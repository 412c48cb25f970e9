// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as glTF describes them: a base colour, metalness and roughness. Included by lighting.glsl.
//
// Nothing around a scene is in a picture that could be reflected, and a metal has no colour but that of its reflections:
// so a bright sky and a darker ground are taken to be there, as bright as the lights that are on.

const float kLeastRoughness = 0.09;  // of less, highlights would be smaller than a pixel
const float kDielectric = 0.04;      // what surfaces that are no metals reflect, seen from the front
const float kLobe = 3.0;     // lights' specular strengths are a third of the diffuse ones, about: here the same light is meant
const float kAround = 0.4;   // how much of a light's diffuse strength comes back from all around
const float kGround = 0.22;  // how bright the ground is, the sky being 1

// metalRoughness: metalness and roughness, [0, 1].
void setMetalRoughness(inout Surface s, vec3 base, vec2 metalRoughness)
{
    s.diffuse = base * (1.0 - metalRoughness.x);
    s.specular = mix(vec3(kDielectric), base, metalRoughness.x);
    s.roughness = max(metalRoughness.y, kLeastRoughness);
}

// The GGX distribution, with one term for visibility and Fresnel's together: R. Zioma, "Optimizing PBR for mobile",
// SIGGRAPH 2015. lit: the cosine to the light, times the share of the light that arrives.
void addReflected(inout Arrived arrived, vec3 colour, vec3 strengths, Surface s, vec3 toLight, float lit)
{
    arrived.around += colour * (strengths.x + kAround * strengths.y);
    vec3 toEye = -normalize(sightTo(s.position));
    vec3 middle = normalize(toLight + toEye + vec3(0.0, 1.0e-6, 0.0));
    float towards = max(dot(s.normal, middle), 0.0);
    float across = max(dot(toLight, middle), 0.1);
    float squared = s.roughness * s.roughness;
    squared *= squared;
    float spread = (squared - 1.0) * towards * towards + 1.0;
    float lobe = squared / (4.0 * spread * spread * across * across * (s.roughness + 0.5));
    arrived.specular += colour * (kLobe * strengths.z * lit * lobe);
}

// What the surface reflects of sky and ground. How much: B. Karis, "Physically based shading on mobile", 2014.
vec3 surroundings(vec3 around, Surface s, vec3 mirrored)
{
    float facing = clamp(dot(s.normal, -normalize(sightTo(s.position))), 0.0, 1.0);
    vec4 r = s.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * facing)) * r.x + r.y;
    vec3 reflected = s.specular * (-1.04 * a + r.z) + (1.04 * a + r.w);
    float blur = mix(0.2, 1.2, s.roughness);
    float sky = mix(kGround, 1.0, smoothstep(-blur, blur, mirrored.y));
    return around * sky * max(reflected, 0.0);
}
