// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Leaves out pixels in which the samples so far are alike, and in those around them: more samples would change nothing
// that one would see.

#include "brightness.glsl"

uniform sampler2D u_sum;  // of the samples: colours, and squares of their brightness
uniform float u_share;    // one over how many samples it is the sum of
uniform vec2 u_first;     // the lower left pixel of those that have a sum, and the upper right one
uniform vec2 u_last;

out vec4 o_colour;

const float kStep = 1.0 / 255.0;
const float kLeast = 2.0 * 2.0 * kStep * kStep;  // variance of one sample: means are then off by half of that

void main()
{
    float most = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            vec2 at = clamp(floor(gl_FragCoord.xy) + vec2(x, y), u_first, u_last);
            vec4 mean = u_share * texelFetch(u_sum, ivec2(at), 0);
            float bright = brightness(mean.rgb);
            most = max(most, mean.a - bright * bright);
        }
    }
    if (most < kLeast) {
        discard;
    }
    o_colour = vec4(1.0);
}
