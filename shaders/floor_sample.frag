// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// The floor in a sample of a refined picture: its colours have been drawn once, as lit and as shaded by targets, and
// only how much light arrives differs from one sample to the next.
//
// HITSCOPE_SHADOWS   defined: of the directional light

#ifdef HITSCOPE_SHADOWS
#include "shadow.glsl"
in vec3 v_shadow;  // as in floor.vert
uniform sampler2D u_floorShaded;
#endif

uniform sampler2D u_floorLit;  // sRGB, opacity

out vec4 o_colour;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    o_colour = texelFetch(u_floorLit, pixel, 0);
#ifdef HITSCOPE_SHADOWS
    o_colour.rgb = mix(texelFetch(u_floorShaded, pixel, 0).rgb, o_colour.rgb, sunlitShare(v_shadow));
#endif
}
