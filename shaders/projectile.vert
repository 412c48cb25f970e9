// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A unit sphere, drawn once for each projectile.

layout(location = 0) in vec3 a_position;
layout(location = 5) in vec4 a_sphere;  // centre, radius

uniform mat4 u_viewProjection;
uniform vec3 u_eye;

out vec3 v_position;  // from the eye
out vec3 v_normal;

void main()
{
    vec3 world = a_sphere.xyz + a_sphere.w * a_position;
    v_position = world - u_eye;
    v_normal = a_position;
    gl_Position = u_viewProjection * vec4(world, 1.0);
}
