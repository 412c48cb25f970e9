// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

in float v_density;

uniform vec4 u_colour;   // sRGB, opacity
uniform float u_pixels;  // across a dot; a pixel of fade around it

out vec4 o_colour;

void main()
{
    float away = length(gl_PointCoord - 0.5) * (u_pixels + 2.0);
    float cover = clamp(0.5 * u_pixels + 0.5 - away, 0.0, 1.0);
    o_colour = vec4(u_colour.rgb, u_colour.a * cover * v_density);
}
