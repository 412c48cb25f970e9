// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

in vec2 v_at;

uniform vec4 u_colour;   // sRGB, opacity
uniform float u_radius;  // of the outline, of the square's half side
uniform float u_width;   // pixels

out vec4 o_colour;

void main()
{
    float r = length(v_at);
    float pixel = max(fwidth(r), 1.0e-9);
    float outline = 1.0 - smoothstep(0.5 * u_width - 0.5, 0.5 * u_width + 0.5, abs(r - u_radius) / pixel);
    float point = 1.0 - smoothstep(1.5 * u_width - 0.5, 1.5 * u_width + 0.5, r / pixel);
    o_colour = vec4(u_colour.rgb, u_colour.a * max(0.8 * outline, point));
}
