// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Which triangle of which target a pixel shows, or which vertex where they are drawn as points. One draw call has
// all of a target's, so that the number of the primitive is that of the triangle or vertex.

uniform uint u_target;

out uvec2 o_element;

void main()
{
    o_element = uvec2(u_target, uint(gl_PrimitiveID));
}
