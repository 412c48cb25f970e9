// SPDX-License-Identifier: GPL-3.0-or-later
#version 430 core
// Applies a batch of hits to the clusters they reach, in place: a work group for each cluster. See
// src/pipeline/hit_batch.h for what the buffers hold.

#include "deform.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) buffer Vertices { float b_vertices[]; };  // position and normal
layout(std430, binding = 1) readonly buffer Hits { vec4 b_hits[]; };  // three a hit, six a curve
layout(std430, binding = 2) readonly buffer Indices { uint b_indices[]; };
layout(std430, binding = 3) readonly buffer Clusters { uvec4 b_clusters[]; };

uniform int u_hitBase;
uniform int u_indexBase;
uniform int u_clusterBase;
uniform int u_firstVertex;  // where the bound part of the vertices starts

#ifdef HITSCOPE_FORMS
vec4 curveTerms(int curve, int pair)
{
    return b_hits[3 * (u_hitBase + curve) + pair];
}
#endif

vec3 load(uint at)
{
    return vec3(b_vertices[at], b_vertices[at + 1u], b_vertices[at + 2u]);
}

void store(uint at, vec3 value)
{
    b_vertices[at] = value.x;
    b_vertices[at + 1u] = value.y;
    b_vertices[at + 2u] = value.z;
}

uint hitAt(uint k)
{
    return 3u * (uint(u_hitBase) + b_indices[uint(u_indexBase) + k]);
}

void main()
{
    uvec4 cluster = b_clusters[uint(u_clusterBase) + gl_WorkGroupID.x];
    for (uint i = gl_LocalInvocationID.x; i < cluster.y; i += gl_WorkGroupSize.x) {
        uint at = 6u * (cluster.x + i - uint(u_firstVertex));
        vec3 position = load(at);
        vec3 normal = load(at + 3u);
        bool reached = false;
        uint k = cluster.z;
        uint last = k + cluster.w;
#ifdef HITSCOPE_FORMS
        // Two loops, as in hits.glsl.
        while (k < last) {
            for (; k < last; ++k) {
                uint hit = hitAt(k);
                vec4 c = b_hits[hit + 2u];
                if (isPaperForm(c.y)) {
                    break;
                }
                vec4 a = b_hits[hit];
                vec4 b = b_hits[hit + 1u];
                if (deformByForm(position, normal, a.xyz, b.xyz, vec3(a.w, b.w, c.x), c.y)) {
                    reached = true;
                }
            }
#endif
            for (; k < last; ++k) {
                uint hit = hitAt(k);
                vec4 c = b_hits[hit + 2u];
#ifdef HITSCOPE_FORMS
                if (!isPaperForm(c.y)) {
                    break;
                }
#endif
                vec4 a = b_hits[hit];
                vec4 b = b_hits[hit + 1u];
                if (deform(position, normal, a.xyz, b.xyz, vec3(a.w, b.w, c.x))) {
                    reached = true;
                }
            }
#ifdef HITSCOPE_FORMS
        }
#endif
        if (reached) {
            store(at, position);
            store(at + 3u, normal);
        }
    }
}
