// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// HITSCOPE_SHADOWS   defined: of the directional light
// HITSCOPE_SHADED    defined: the directional light does not arrive anywhere
// HITSCOPE_OPEN      defined: what is close by keeps light away

#include "light_terms.glsl"
#include "tone.glsl"
#ifdef HITSCOPE_SHADOWS
#include "shadow.glsl"
in vec3 v_shadow;
#endif

in vec4 v_place;  // this and the rest as in floor.vert
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
uniform vec2 u_spotCone;
#endif

uniform vec4 u_lineColour;  // sRGB, opacity
uniform float u_cellFade;   // [0, 1]: how far the finest lines have faded, on the way to ten times the size
#ifdef HITSCOPE_OPEN
uniform sampler2D u_floorOpen;  // floor_open.frag's
uniform vec2 u_perPixel;        // one over the picture's size
#endif

out vec4 o_colour;

// Lines between cells, `pixels` wide, antialiased; they fade where cells become too small to be told apart. at: in
// cells; width: of a pixel, in these; perWidth: one over that.
float lines(vec2 at, vec2 width, vec2 perWidth, float pixels)
{
    vec2 off = abs(at - floor(at + 0.5)) * perWidth;
    vec2 line = clamp(0.5 * pixels + 0.5 - off, 0.0, 1.0);  // the share of a pixel that it covers
    line *= clamp(1.3 - 2.6 * width, 0.0, 1.0);
    return max(line.x, line.y);
}

// The paper's equations 7-14 for a matte surface that looks up. A light's share is a quotient whose parts have a
// division in common: one over the distance, and over the attenuation.
vec3 floorLight(float sunlit)
{
    vec3 light = vec3(0.0);
#ifdef HITSCOPE_DIRECTIONAL
    light += v_sun.rgb * (v_sun.w + sunlit);
#endif
#ifdef HITSCOPE_POINTS
    for (int i = 0; i < HITSCOPE_POINTS; ++i) {
        vec3 way = v_pointPlace[i].xyz - vec3(v_place.x, 0.0, v_place.y);
        float away = sqrt(max(dot(way, way), 1.0e-12));
        float share = 1.0 / (away * weakened(vec2(v_pointPlace[i].w, v_pointColour[i].w), away));
        light += v_pointColour[i].rgb * (share * (v_pointAmbient[i] * away + max(way.y, 0.0)));
    }
#endif
#ifdef HITSCOPE_SPOT
    vec3 way = v_spotPlace.xyz - vec3(v_place.x, 0.0, v_place.y);
    float away = sqrt(max(dot(way, way), 1.0e-12));
    float weaker = weakened(vec2(v_spotPlace.w, v_spotDirection.w), away);
    float share = 1.0 / (away * weaker);
    float within = withinCone(u_spotCone, dot(way, v_spotDirection.xyz) * (share * weaker));
    light += v_spotColour.rgb * (share * (v_spotColour.w * away + within * max(way.y, 0.0)));
#endif
    return light;
}

void main()
{
    vec2 cells = v_place.zw;
    vec2 width = max(fwidth(cells), vec2(1.0e-6));
    vec2 perWidth = 1.0 / width;
    float fine = 0.45 * (1.0 - u_cellFade) * lines(cells, width, perWidth, 1.0);
    float middle = mix(0.8, 0.45, u_cellFade) * lines(0.1 * cells, 0.1 * width, 10.0 * perWidth, 1.2);
    float coarse = 0.8 * lines(0.01 * cells, 0.01 * width, 100.0 * perWidth, 1.4);
    float line = u_lineColour.a * max(fine, max(middle, coarse));

    float sunlit = 1.0;
#ifdef HITSCOPE_SHADED
    sunlit = 0.0;
#elif defined(HITSCOPE_SHADOWS)
    sunlit = sunlitShare(v_shadow);
#endif
    vec3 colour = mix(display(floorLight(sunlit)), u_lineColour.rgb, line);
#ifdef HITSCOPE_OPEN
    colour *= texture(u_floorOpen, gl_FragCoord.xy * u_perPixel).r;
#endif
    float opacity = 1.0 - smoothstep(0.15, 1.0, length(v_place.xy));
    // The square's front is below: from there one looks through the floor.
    o_colour = vec4(colour, opacity * (gl_FrontFacing ? 0.25 : 1.0));
}
