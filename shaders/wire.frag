// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// HITSCOPE_WIDE   defined: the line is two triangles (wide_line.glsl); else it is a line of one pixel

#ifdef HITSCOPE_WIDE
in float g_density;
noperspective in float g_across;  // pixels from the line's middle

uniform float u_halfWidth;  // pixels
#else
in float v_density;
#endif

uniform vec4 u_colour;  // sRGB, opacity

out vec4 o_colour;

void main()
{
#ifdef HITSCOPE_WIDE
    float density = g_density;
    float cover = clamp(u_halfWidth + 0.5 - abs(g_across), 0.0, 1.0);
#else
    float density = v_density;
    float cover = 1.0;
#endif
    o_colour = vec4(u_colour.rgb, u_colour.a * cover * density);
}
