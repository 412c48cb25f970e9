// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A disc with a line of another colour around it, so that it is seen on anything; without fill, a ring.

uniform float u_size;       // pixels
uniform float u_line;       // pixels
uniform float u_fill;       // opacity within
uniform float u_opacity;    // of all
uniform vec3 u_colour;      // sRGB
uniform vec3 u_lineColour;  // sRGB

out vec4 o_colour;

void main()
{
    float r = length(gl_PointCoord - 0.5) * u_size;
    float outer = 0.5 * u_size;
    float disc = clamp(outer - r, 0.0, 1.0);
    float within = clamp(outer - u_line - r + 0.5, 0.0, 1.0);
    float ring = within * clamp(r - (outer - 2.5 * u_line) + 0.5, 0.0, 1.0);
    float inside = mix(ring, within, u_fill);
    o_colour = vec4(mix(u_lineColour, u_colour, inside),
                    u_opacity * disc * max(inside, mix(1.0 - within, 1.0, u_fill) * 0.75));
}
