// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Targets (paper, equations 5 and 6; model matrices are rigid, so their own rotation turns normals).

#include "hits.glsl"
#include "change.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
layout(location = 3) in vec3 a_shadingNormal;

uniform mat4 u_model;
uniform mat4 u_viewProjection;
uniform int u_paperNormals;  // 0: shade with the true normals

out vec3 v_position;
out vec3 v_normal;
out vec2 v_texcoord;

// The wireframe and the depth-only pass must land on the very same depths.
invariant gl_Position;

void main()
{
    // Hits live in the target's local frame: they come before the model matrix.
    vec3 position = a_position;
    vec3 normal = a_normal;
    applyHits(position, normal);

#ifdef HITSCOPE_CHANGE_MAP
    v_change = changeOf(position, normal, a_shadingNormal);
#endif
    vec4 world = u_model * vec4(drawnPosition(position), 1.0);
    v_position = world.xyz;
    v_normal = mat3(u_model) * (u_paperNormals != 0 ? normal : a_shadingNormal);
    v_texcoord = a_texcoord;
    gl_Position = u_viewProjection * world;
}
