// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A line with a thin edge of another colour, so that it is seen on anything; dashed where u_dash says so.

in float g_along;                 // metres
noperspective in float g_across;  // pixels from the line's middle

uniform float u_halfWidth;  // pixels, without the edge
uniform float u_edge;       // pixels
uniform float u_dash;       // metres from one dash to the next; 0: a line
uniform vec4 u_colour;      // sRGB, opacity
uniform vec3 u_edgeColour;  // sRGB

out vec4 o_colour;

void main()
{
    float off = abs(g_across);
    float core = clamp(u_halfWidth + 0.5 - off, 0.0, 1.0);
    float cover = clamp(u_halfWidth + u_edge + 0.5 - off, 0.0, 1.0);
    if (u_dash > 0.0 && fract(g_along / u_dash) > 0.6) {
        discard;
    }
    o_colour = vec4(mix(u_edgeColour, u_colour.rgb, core), u_colour.a * max(core, 0.85 * cover));
}
