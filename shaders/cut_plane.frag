// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// The cutting plane itself, as a pane with an outline.

in vec2 v_at;  // [-1, 1]

uniform vec3 u_colour;  // sRGB
uniform float u_fill;   // opacity
uniform float u_line;   // opacity
uniform float u_width;  // pixels

out vec4 o_colour;

void main()
{
    vec2 pixels = (1.0 - abs(v_at)) / max(fwidth(v_at), vec2(1.0e-9));
    float edge = 1.0 - smoothstep(u_width - 0.5, u_width + 0.5, min(pixels.x, pixels.y));
    o_colour = vec4(u_colour, mix(u_fill, u_line, edge));
}
