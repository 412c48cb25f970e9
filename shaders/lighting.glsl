// SPDX-License-Identifier: GPL-3.0-or-later
// Phong lighting by the paper's equations 7-14: a directional light, point lights, a spotlight. All positions are
// metres from the eye, along the world's axes; all colours linear.
//
// HITSCOPE_DIRECTIONAL   defined: the directional light is on
// HITSCOPE_POINTS        defined: the number of point lights that are on
// HITSCOPE_POINTS_ALIKE  defined: these differ in place and colour only
// HITSCOPE_SPOT          defined: the spotlight is on; 1: at the eye, 2: at a place of its own
// HITSCOPE_MATTE         defined: the surface has no specular colour, so none is worked out
// HITSCOPE_METAL_ROUGHNESS  defined: metalness and roughness take the place of the specular terms
//
// A light has one colour and three strengths rather than three colours, and lights that are off are not in the
// program: a software renderer fetches each number of a uniform for each pixel on its own, and that costs it more
// than all the arithmetic below.

#include "light_terms.glsl"
#include "sight.glsl"

struct Surface {
    vec3 position;
    vec3 normal;  // unit, towards the eye
    vec3 diffuse;
    vec3 specular;
#ifdef HITSCOPE_METAL_ROUGHNESS
    float roughness;
#else
    float shininess;
#endif
    float sunlit;  // [0, 1]: how much of the directional light is not in shadow
};

// Of a light: its colour (of a point light or spotlight: over the attenuation's constant factor), and how strong
// its ambient, diffuse and specular terms are.
#ifdef HITSCOPE_DIRECTIONAL
uniform vec3 u_directionalDirection;  // unit, towards the light
uniform vec3 u_directionalColour;
uniform vec3 u_directionalStrengths;
#endif

#ifdef HITSCOPE_POINTS
#ifdef HITSCOPE_POINTS_ALIKE
#define POINT_TERMS 1
#define POINT_TERM(i) 0
#else
#define POINT_TERMS HITSCOPE_POINTS
#define POINT_TERM(i) i
#endif
uniform vec3 u_pointPosition[HITSCOPE_POINTS];
uniform vec2 u_pointAttenuation[POINT_TERMS];  // linear, quadratic
uniform vec3 u_pointColour[HITSCOPE_POINTS];
uniform vec3 u_pointStrengths[POINT_TERMS];
#endif

#ifdef HITSCOPE_SPOT
#if HITSCOPE_SPOT == 2
uniform vec3 u_spotPosition;
#endif
uniform vec3 u_spotDirection;  // unit, towards the light
uniform vec2 u_spotAttenuation;
uniform vec2 u_spotCone;
uniform vec3 u_spotColour;
uniform vec3 u_spotStrengths;
#endif

// The light that arrives, before the surface's own colours.
struct Arrived {
    vec3 diffuse;
    vec3 specular;
#ifdef HITSCOPE_METAL_ROUGHNESS
    vec3 around;  // from everywhere
#endif
};

#ifdef HITSCOPE_METAL_ROUGHNESS
#include "metal_roughness.glsl"
#endif

// Equations 7-11. toLight: a unit vector; share: [0, 1], of the diffuse and specular terms. mirrored: the way to the
// eye, reflected by the surface: dot(toEye, reflect(-toLight, n)) of equation 9 is the same number as
// dot(toLight, mirrored), and that reflection is needed only once. The specular term needs a lit side, or it would
// shine through.
void addLight(inout Arrived arrived, vec3 colour, vec3 strengths, Surface s, vec3 mirrored, vec3 toLight, float share)
{
    float diff = max(dot(s.normal, toLight), 0.0);
    arrived.diffuse += colour * (strengths.x + strengths.y * share * diff);
#ifdef HITSCOPE_METAL_ROUGHNESS
    addReflected(arrived, colour, strengths, s, toLight, share * diff);
#elif !defined(HITSCOPE_MATTE)
    float spec = diff > 0.0 ? pow(max(dot(toLight, mirrored), 1.0e-6), s.shininess) : 0.0;
    arrived.specular += colour * (strengths.z * share * spec);
#endif
}

vec3 phong(Surface s)
{
    float eyeSquared = max(dot(s.position, s.position), 1.0e-12);
    float perEye = inversesqrt(eyeSquared);
    vec3 toEye = -s.position * perEye;
#ifdef HITSCOPE_ORTHOGRAPHIC
    vec3 mirrored = reflect(u_lookAlong, s.normal);
#else
    vec3 mirrored = reflect(-toEye, s.normal);
#endif

    Arrived arrived;
    arrived.diffuse = vec3(0.0);
    arrived.specular = vec3(0.0);
#ifdef HITSCOPE_METAL_ROUGHNESS
    arrived.around = vec3(0.0);
#endif
#ifdef HITSCOPE_DIRECTIONAL
    addLight(arrived, u_directionalColour, u_directionalStrengths, s, mirrored, u_directionalDirection, s.sunlit);
#endif
#ifdef HITSCOPE_POINTS
    for (int i = 0; i < HITSCOPE_POINTS; ++i) {
        // Equation 13.
        vec3 way = u_pointPosition[i] - s.position;
        float squared = max(dot(way, way), 1.0e-12);
        float perDistance = inversesqrt(squared);
        vec3 colour = u_pointColour[i] * attenuation(u_pointAttenuation[POINT_TERM(i)], squared * perDistance);
        addLight(arrived, colour, u_pointStrengths[POINT_TERM(i)], s, mirrored, way * perDistance, 1.0);
    }
#endif
#ifdef HITSCOPE_SPOT
#if HITSCOPE_SPOT == 2
    vec3 spotWay = u_spotPosition - s.position;
    float spotSquared = max(dot(spotWay, spotWay), 1.0e-12);
    float perSpot = inversesqrt(spotSquared);
    vec3 toSpot = spotWay * perSpot;
#else
    float spotSquared = eyeSquared;
    float perSpot = perEye;
    vec3 toSpot = toEye;
#endif
    float share = withinCone(u_spotCone, dot(toSpot, u_spotDirection));
    vec3 spotColour = u_spotColour * attenuation(u_spotAttenuation, spotSquared * perSpot);
    addLight(arrived, spotColour, u_spotStrengths, s, mirrored, toSpot, share);
#endif
#ifdef HITSCOPE_METAL_ROUGHNESS
    return arrived.diffuse * s.diffuse + arrived.specular * s.specular + surroundings(arrived.around, s, mirrored);
#elif defined(HITSCOPE_MATTE)
    return arrived.diffuse * s.diffuse;
#else
    return arrived.diffuse * s.diffuse + arrived.specular * s.specular;
#endif
}
