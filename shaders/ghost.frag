// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A target as it was, like glass over what has become of it: clear where one looks straight through, denser at its rim.

#include "sight.glsl"

in vec3 v_position;  // from the eye
in vec3 v_normal;

uniform vec4 u_colour;  // sRGB, opacity

out vec4 o_colour;

void main()
{
    float facing = abs(dot(normalize(v_normal), normalize(sightTo(v_position))));
    float grazing = 1.0 - facing;
    o_colour = vec4(u_colour.rgb, u_colour.a * mix(0.22, 0.7, grazing * grazing));
}
