// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A square of the floor's plane around a centre. What its light is made of goes to the pixels as flat inputs, times
// the floor's own colour, and places as inputs: to a software renderer these cost next to nothing, which is not true of
// uniforms. There are fifteen inputs, as many as OpenGL 3.3 has for certain.
//
// Places of lights are those from the centre, in halves of the square's side; attenuations are for such distances.

#define HITSCOPE_MATTE
#include "lighting.glsl"

uniform mat4 u_viewProjection;
uniform vec3 u_eye;
uniform vec3 u_centre;
uniform float u_reach;  // metres, half the square's side
uniform vec3 u_diffuse;  // linear
uniform float u_cell;       // metres between the finest lines
uniform vec2 u_fromLines;   // the centre's x and z from a crossing of the coarsest lines, metres
#ifdef HITSCOPE_SHADOWS
uniform mat3 u_floorShadow;  // from (x, z, 1) of the floor to the shadow map's texture coordinates and depth
#endif

out vec4 v_place;  // x and z in the square, [-1, 1]; and in cells of the finest lines
#ifdef HITSCOPE_SHADOWS
out vec3 v_shadow;  // texture coordinates and depth
#endif
// Colours are times the diffuse strength; with the ambient one divided by that, which no light is quite without.
#ifdef HITSCOPE_DIRECTIONAL
flat out vec4 v_sun;  // colour, ambient
#endif
#ifdef HITSCOPE_POINTS
flat out vec4 v_pointPlace[HITSCOPE_POINTS];   // and linear attenuation
flat out vec4 v_pointColour[HITSCOPE_POINTS];  // and quadratic attenuation
flat out vec4 v_pointAmbient;                  // of each light
#endif
#ifdef HITSCOPE_SPOT
flat out vec4 v_spotPlace;      // and linear attenuation
flat out vec4 v_spotDirection;  // towards the light, and quadratic attenuation
flat out vec4 v_spotColour;     // and ambient
#endif

const float kLeast = 1.0e-6;

// position: from the eye.
vec3 inSquare(vec3 position)
{
    return (position + u_eye - u_centre) / u_reach;
}

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    vec3 world = u_centre + u_reach * vec3(corner.x, 0.0, corner.y);
    gl_Position = u_viewProjection * vec4(world, 1.0);
    v_place = vec4(corner, (u_fromLines + u_reach * corner) / u_cell);
#ifdef HITSCOPE_SHADOWS
    v_shadow = u_floorShadow * vec3(world.xz, 1.0);
#endif

#ifdef HITSCOPE_DIRECTIONAL
    float sun = max(u_directionalStrengths.y * u_directionalDirection.y, kLeast);
    v_sun = vec4(u_directionalColour * u_diffuse * sun, u_directionalStrengths.x / sun);
#endif
#ifdef HITSCOPE_POINTS
    v_pointAmbient = vec4(0.0);
    for (int i = 0; i < HITSCOPE_POINTS; ++i) {
        float diffuse = max(u_pointStrengths[POINT_TERM(i)].y, kLeast);
        vec2 attenuation = u_pointAttenuation[POINT_TERM(i)] * vec2(u_reach, u_reach * u_reach);
        v_pointPlace[i] = vec4(inSquare(u_pointPosition[i]), attenuation.x);
        v_pointColour[i] = vec4(u_pointColour[i] * u_diffuse * diffuse, attenuation.y);
        v_pointAmbient[i] = u_pointStrengths[POINT_TERM(i)].x / diffuse;
    }
#endif
#ifdef HITSCOPE_SPOT
#if HITSCOPE_SPOT == 2
    vec3 spot = u_spotPosition;
#else
    vec3 spot = vec3(0.0);
#endif
    float spotDiffuse = max(u_spotStrengths.y, kLeast);
    v_spotPlace = vec4(inSquare(spot), u_spotAttenuation.x * u_reach);
    v_spotDirection = vec4(u_spotDirection, u_spotAttenuation.y * u_reach * u_reach);
    v_spotColour = vec4(u_spotColour * u_diffuse * spotDiffuse, u_spotStrengths.x / spotDiffuse);
#endif
}
