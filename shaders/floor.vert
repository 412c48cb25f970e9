// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A square of the floor's plane around a centre. What its light is made of goes to the pixels as flat inputs, times
// the floor's own colour: to a software renderer these cost next to nothing, which is not true of uniforms. There are
// fifteen of them with the position, as many as OpenGL 3.3 has for certain.

#define HITSCOPE_MATTE
#include "lighting.glsl"

uniform mat4 u_viewProjection;
uniform vec3 u_eye;
uniform vec3 u_centre;
uniform float u_reach;  // metres, half the square's side
uniform vec3 u_diffuse;  // linear

out vec3 v_position;  // from the eye
#ifdef HITSCOPE_DIRECTIONAL
flat out vec4 v_sun;  // colour, and how strong it is in shadow
#endif
#ifdef HITSCOPE_POINTS
flat out vec4 v_pointPlace[HITSCOPE_POINTS];   // position, linear attenuation
flat out vec4 v_pointColour[HITSCOPE_POINTS];  // times the diffuse strength; quadratic attenuation
flat out vec4 v_pointAmbient;                  // of each light: of the diffuse strength
#endif
#ifdef HITSCOPE_SPOT
flat out vec4 v_spotPlace;      // position, linear attenuation
flat out vec4 v_spotDirection;  // towards the light, quadratic attenuation
flat out vec4 v_spotColour;     // and its ambient strength
#endif
flat out vec4 v_strengths;  // diffuse, of the sun and of the spotlight; the spotlight's cone

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    vec3 world = u_centre + u_reach * vec3(corner.x, 0.0, corner.y);
    v_position = world - u_eye;
    gl_Position = u_viewProjection * vec4(world, 1.0);

    v_strengths = vec4(0.0);
#ifdef HITSCOPE_DIRECTIONAL
    v_sun = vec4(u_directionalColour * u_diffuse, u_directionalStrengths.x);
    v_strengths.x = u_directionalStrengths.y * max(u_directionalDirection.y, 0.0);
#endif
#ifdef HITSCOPE_POINTS
    v_pointAmbient = vec4(0.0);
    for (int i = 0; i < HITSCOPE_POINTS; ++i) {
        // A light without a diffuse term has a floor's ambient term all the same.
        float diffuse = max(u_pointStrengths[POINT_TERM(i)].y, 1.0e-6);
        v_pointPlace[i] = vec4(u_pointPosition[i], u_pointAttenuation[POINT_TERM(i)].x);
        v_pointColour[i] = vec4(u_pointColour[i] * u_diffuse * diffuse, u_pointAttenuation[POINT_TERM(i)].y);
        v_pointAmbient[i] = u_pointStrengths[POINT_TERM(i)].x / diffuse;
    }
#endif
#ifdef HITSCOPE_SPOT
#if HITSCOPE_SPOT == 2
    v_spotPlace = vec4(u_spotPosition, u_spotAttenuation.x);
#else
    v_spotPlace = vec4(vec3(0.0), u_spotAttenuation.x);
#endif
    v_spotDirection = vec4(u_spotDirection, u_spotAttenuation.y);
    v_spotColour = vec4(u_spotColour * u_diffuse, u_spotStrengths.x);
    v_strengths.yzw = vec3(u_spotStrengths.y, u_spotCone);
#endif
}
