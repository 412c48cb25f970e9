// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Four arms around a gap, light with a dark edge so that it shows on anything.

in vec2 v_pixel;

uniform float u_pixelRatio;

out vec4 o_colour;

// How much of the pixel is within `margin` logical pixels of the arms.
float arms(float margin)
{
    vec2 p = abs(v_pixel) / u_pixelRatio;
    float along = max(p.x, p.y);
    float across = min(p.x, p.y);
    float soft = 0.5 / u_pixelRatio;
    float inside = smoothstep(4.0 - margin - soft, 4.0 - margin + soft, along) *
                   (1.0 - smoothstep(10.0 + margin - soft, 10.0 + margin + soft, along));
    return inside * (1.0 - smoothstep(0.75 + margin - soft, 0.75 + margin + soft, across));
}

void main()
{
    float light = arms(0.0);
    float dark = arms(1.0);
    o_colour = vec4(vec3(light), max(0.95 * light, 0.5 * dark));
}
