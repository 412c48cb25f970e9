// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Hands on the number of the primitive, for drivers that do not tell fragments (Mesa's softpipe draws nothing where a
// fragment asks).
//
// HITSCOPE_POINTS   defined: of vertices drawn as points; else of triangles

#ifdef HITSCOPE_POINTS
#define CORNERS 1
layout(points) in;
layout(points, max_vertices = 1) out;
#else
#define CORNERS 3
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
#endif

in vec3 v_position[];

out vec3 g_position;
flat out int g_primitive;

void main()
{
    for (int i = 0; i < CORNERS; ++i) {
#ifdef HITSCOPE_CUT
        gl_ClipDistance[0] = gl_in[i].gl_ClipDistance[0];
#endif
        g_position = v_position[i];
        g_primitive = gl_PrimitiveIDIn;
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
