// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

in float v_density;

uniform vec4 u_colour;  // sRGB, opacity

out vec4 o_colour;

void main()
{
    o_colour = vec4(u_colour.rgb, u_colour.a * mix(0.15, 1.0, v_density));
}
