// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// HITSCOPE_SHADOWS   defined: of the directional light
// HITSCOPE_SHADED    defined: the directional light does not arrive anywhere
// HITSCOPE_OPEN      defined: what is close by keeps light away

#include "light_terms.glsl"
#include "tone.glsl"
#ifdef HITSCOPE_SHADOWS
#include "shadow.glsl"
uniform mat3 u_floorShadow;  // from (x, z, 1) of the floor to the shadow map's texture coordinates and depth
#endif

in vec3 v_position;  // from the eye; the rest as in floor.vert
#ifdef HITSCOPE_DIRECTIONAL
flat in vec4 v_sun;
#endif
#ifdef HITSCOPE_POINTS
flat in vec4 v_pointPlace[HITSCOPE_POINTS];
flat in vec4 v_pointColour[HITSCOPE_POINTS];
flat in vec4 v_pointAmbient;
#endif
#ifdef HITSCOPE_SPOT
flat in vec4 v_spotPlace;
flat in vec4 v_spotDirection;
flat in vec4 v_spotColour;
#endif
flat in vec4 v_strengths;

uniform vec3 u_eye;
uniform vec3 u_centre;
uniform float u_reach;
uniform vec4 u_lineColour;  // sRGB, opacity
uniform float u_cell;       // metres between the finest lines
uniform float u_cellFade;   // [0, 1]: how far these have faded, on the way to ten times the size
#ifdef HITSCOPE_OPEN
uniform sampler2D u_floorOpen;  // floor_open.frag's
uniform vec2 u_perPixel;        // one over the picture's size
#endif

out vec4 o_colour;

// Lines `pixels` wide, antialiased; they fade where cells become too small to be told apart.
float lines(vec2 plane, float cell, float pixels)
{
    vec2 at = plane / cell;
    vec2 width = max(fwidth(at), vec2(1.0e-6));
    vec2 off = abs(fract(at - 0.5) - 0.5) / width;
    vec2 line = 1.0 - smoothstep(vec2(0.5 * pixels - 0.5), vec2(0.5 * pixels + 0.5), off);
    line *= 1.0 - smoothstep(vec2(0.12), vec2(0.45), width);
    return max(line.x, line.y);
}

// The paper's equations 7-14 for a matte surface that looks up.
vec3 floorLight(float sunlit)
{
    vec3 light = vec3(0.0);
#ifdef HITSCOPE_DIRECTIONAL
    light += v_sun.rgb * (v_sun.w + v_strengths.x * sunlit);
#endif
#ifdef HITSCOPE_POINTS
    for (int i = 0; i < HITSCOPE_POINTS; ++i) {
        vec3 way = v_pointPlace[i].xyz - v_position;
        float squared = max(dot(way, way), 1.0e-12);
        float perDistance = inversesqrt(squared);
        float share = attenuation(vec2(v_pointPlace[i].w, v_pointColour[i].w), squared * perDistance);
        light += v_pointColour[i].rgb * (share * (v_pointAmbient[i] + max(way.y * perDistance, 0.0)));
    }
#endif
#ifdef HITSCOPE_SPOT
    vec3 way = v_spotPlace.xyz - v_position;
    float squared = max(dot(way, way), 1.0e-12);
    float perDistance = inversesqrt(squared);
    float within = withinCone(v_strengths.zw, dot(way, v_spotDirection.xyz) * perDistance);
    float share = attenuation(vec2(v_spotPlace.w, v_spotDirection.w), squared * perDistance);
    light += v_spotColour.rgb *
             (share * (v_spotColour.w + v_strengths.y * within * max(way.y * perDistance, 0.0)));
#endif
    return light;
}

void main()
{
    vec2 plane = v_position.xz + u_eye.xz;
    float fine = 0.45 * (1.0 - u_cellFade) * lines(plane, u_cell, 1.0);
    float middle = mix(0.8, 0.45, u_cellFade) * lines(plane, 10.0 * u_cell, 1.2);
    float coarse = 0.8 * lines(plane, 100.0 * u_cell, 1.4);
    float line = u_lineColour.a * max(fine, max(middle, coarse));

    float sunlit = 1.0;
#ifdef HITSCOPE_SHADED
    sunlit = 0.0;
#elif defined(HITSCOPE_SHADOWS)
    sunlit = sunlitShare(u_floorShadow * vec3(plane, 1.0));
#endif
    vec3 light = display(floorLight(sunlit));
    vec3 colour = mix(light, u_lineColour.rgb, line);
#ifdef HITSCOPE_OPEN
    colour *= texture(u_floorOpen, gl_FragCoord.xy * u_perPixel).r;
#endif
    float away = distance(plane, u_centre.xz) / u_reach;
    float opacity = 1.0 - smoothstep(0.15, 1.0, away);
    // From below one looks through the floor.
    bool below = v_position.y > 0.0;
    o_colour = vec4(colour, opacity * (below ? 0.25 : 1.0));
}
