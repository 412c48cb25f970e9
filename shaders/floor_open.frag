// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// How much of the light around arrives at the floor of a refined picture: the mean of many samples, of fewer pixels, as
// the floor is plane and its light even.

#define HITSCOPE_ALIKE
#include "occlusion.glsl"

uniform vec2 u_pixels;  // of the whole picture, in each of these
uniform int u_samples;  // a constant would have compilers write the loop out, which takes them a quarter of a second

out float o_open;

const vec2 kTurn = vec2(0.618034, 0.754878);  // as RefinedPicture::sampleAt()

void main()
{
    float sum = 0.0;
    for (int i = 0; i < u_samples; ++i) {
        sum += openShareAt(gl_FragCoord.xy * u_pixels, gl_FragCoord.z, vec3(0.0, 1.0, 0.0), fract(float(i) * kTurn));
    }
    o_open = sum / float(u_samples);
}
