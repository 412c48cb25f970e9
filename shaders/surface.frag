// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// HITSCOPE_TEXTURED   defined: the diffuse colour comes from a texture too, and where that is transparent there is
//                     no surface. A program of its own, because a shader that may discard is run on hidden pixels.
// HITSCOPE_CHANGE_MAP defined: the surface has the colour of a quantity of change, softly lit (change_map.glsl)

#include "lighting.glsl"
#include "tone.glsl"
#include "change_map.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec2 v_texcoord;

uniform vec3 u_diffuse;
uniform vec3 u_specular;
uniform float u_shininess;
uniform float u_opacity;
uniform sampler2D u_texture;
uniform vec4 u_rim;        // linear colour and strength of the selected target's rim
uniform vec4 u_ring;       // centre and radius of the highlighted hit; radius 0: none
uniform vec3 u_ringColour;
uniform float u_ringWidth;  // pixels

out vec4 o_colour;

vec3 facingNormal()
{
    vec3 normal = v_normal;
    if (dot(normal, normal) < 1.0e-12) {
        normal = cross(dFdx(v_position), dFdy(v_position));
        return dot(normal, u_eye - v_position) < 0.0 ? -normalize(normal) : normalize(normal);
    }
    normal = normalize(normal);
    return gl_FrontFacing ? normal : -normal;
}

// Where the highlighted hit's sphere cuts the surface: its max_distance, seen on the mesh.
float ring()
{
    if (u_ring.w <= 0.0) {
        return 0.0;
    }
    float off = distance(v_position, u_ring.xyz) - u_ring.w;
    float pixel = max(fwidth(off), 1.0e-9);
    float edge = 1.0 - smoothstep(0.5 * u_ringWidth - 0.5, 0.5 * u_ringWidth + 0.5, abs(off) / pixel);
    return max(0.9 * edge, off < 0.0 ? 0.12 : 0.0);
}

void main()
{
    float ringed = ring();
#ifdef HITSCOPE_CHANGE_MAP
    vec3 mapped = changeColour(abs(dot(facingNormal(), normalize(u_eye - v_position))));
    o_colour = vec4(toSrgb(mix(mapped, u_ringColour, ringed)), u_opacity);
    return;
#endif
    vec3 albedo = u_diffuse;
#ifdef HITSCOPE_TEXTURED
    vec4 texel = texture(u_texture, vec2(v_texcoord.x, 1.0 - v_texcoord.y));
    if (texel.a < 0.5) {
        discard;
    }
    albedo *= texel.rgb;
#endif
    Surface surface;
    surface.position = v_position;
    surface.normal = facingNormal();
    surface.diffuse = albedo;
    surface.specular = u_specular;
    surface.shininess = u_shininess;

    vec3 light = phong(surface);
    float grazing = 1.0 - abs(dot(surface.normal, normalize(u_eye - v_position)));
    light += u_rim.rgb * (u_rim.a * grazing * grazing * grazing);
    light = mix(light, u_ringColour, ringed);
    o_colour = vec4(display(light), u_opacity);
}
