// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A unit sphere, drawn once for each projectile.

layout(location = 0) in vec3 a_position;
layout(location = 5) in vec4 a_sphere;  // centre, radius

uniform mat4 u_viewProjection;

out vec3 v_position;
out vec3 v_normal;
out vec2 v_texcoord;

void main()
{
    v_position = a_sphere.xyz + a_sphere.w * a_position;
    v_normal = a_position;
    v_texcoord = vec2(0.0);
    gl_Position = u_viewProjection * vec4(v_position, 1.0);
}
