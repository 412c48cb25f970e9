// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// One hit on vertices that transform feedback hands back: what the start-up self-test compares with deform() in C++.

#include "deform.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform vec3 u_point;
uniform vec3 u_direction;
uniform vec3 u_constants;
#ifdef HITSCOPE_FORMS
uniform float u_form;
uniform vec4 u_curve[4];

vec4 curveTerms(int curve, int pair)
{
    return u_curve[pair];
}
#endif

out vec3 capturedPosition;
out vec3 capturedNormal;

void main()
{
    vec3 position = a_position;
    vec3 normal = a_normal;
#ifdef HITSCOPE_FORMS
    if (isPaperForm(u_form)) {
        deform(position, normal, u_point, u_direction, u_constants);
    } else {
        deformByForm(position, normal, u_point, u_direction, u_constants, u_form);
    }
#else
    deform(position, normal, u_point, u_direction, u_constants);
#endif
    capturedPosition = position;
    capturedNormal = normal;
    gl_Position = vec4(position, 1.0);
}
