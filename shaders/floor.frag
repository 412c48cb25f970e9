// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

#define HITSCOPE_MATTE
#include "lighting.glsl"
#include "tone.glsl"

in vec3 v_position;

uniform vec3 u_centre;
uniform float u_reach;
uniform vec3 u_diffuse;     // linear
uniform vec4 u_lineColour;  // sRGB, opacity
uniform float u_cell;       // metres between the finest lines
uniform float u_cellFade;   // [0, 1]: how far these have faded, on the way to ten times the size

out vec4 o_colour;

// Lines `pixels` wide, antialiased; they fade where cells become too small to be told apart.
float lines(float cell, float pixels)
{
    vec2 at = v_position.xz / cell;
    vec2 width = max(fwidth(at), vec2(1.0e-6));
    vec2 off = abs(fract(at - 0.5) - 0.5) / width;
    vec2 line = 1.0 - smoothstep(vec2(0.5 * pixels - 0.5), vec2(0.5 * pixels + 0.5), off);
    line *= 1.0 - smoothstep(vec2(0.12), vec2(0.45), width);
    return max(line.x, line.y);
}

void main()
{
    Surface surface;
    surface.position = v_position;
    surface.normal = vec3(0.0, 1.0, 0.0);
    surface.diffuse = u_diffuse;
    surface.specular = vec3(0.0);
    surface.shininess = 1.0;

    float fine = 0.45 * (1.0 - u_cellFade) * lines(u_cell, 1.0);
    float middle = mix(0.8, 0.45, u_cellFade) * lines(10.0 * u_cell, 1.2);
    float coarse = 0.8 * lines(100.0 * u_cell, 1.4);
    float line = u_lineColour.a * max(fine, max(middle, coarse));

    vec3 colour = mix(display(phong(surface)), u_lineColour.rgb, line);
    float away = distance(v_position.xz, u_centre.xz) / u_reach;
    float opacity = 1.0 - smoothstep(0.15, 1.0, away);
    // From below one looks through the floor.
    bool below = u_eye.y < v_position.y;
    o_colour = vec4(colour, opacity * (below ? 0.25 : 1.0));
}
