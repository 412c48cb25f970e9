// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// HITSCOPE_TEXTURED      defined: the diffuse colour comes from a texture too, and where that is transparent there is
//                        no surface. A program of its own, because a shader that may discard is run on hidden pixels.
// HITSCOPE_NORMAL_MAP    defined: a tangent-space normal map turns the normal
// HITSCOPE_METAL_ROUGHNESS      defined: metalness and roughness say how the surface reflects (metal_roughness.glsl)
// HITSCOPE_METAL_ROUGHNESS_MAP  defined: a texture scales them
// HITSCOPE_TEXCOORDS     defined where one of these textures is
// HITSCOPE_COLOURS       defined: vertices have colours, which the diffuse colour is multiplied by
// HITSCOPE_TRANSLUCENT   defined: there is an opacity
// HITSCOPE_FLAT          defined: one normal a triangle
// HITSCOPE_BACK_FACES    defined: they are tinted
// HITSCOPE_SHADOWS       defined: of the directional light
// HITSCOPE_MARKS         defined: something is selected: a target's rim, a hit's ring
// HITSCOPE_CUT           defined: one sees into the targets; their inside has a colour of its own, and the light that
//                        would come in there
// HITSCOPE_CUT_FILLED    defined: the cutting plane closes what it opens
// HITSCOPE_ENVIRONMENT   defined: a studio lights it, not the lights (environment.glsl)
// HITSCOPE_MATCAP        defined: the normal alone says the colour (matcap.glsl)
// HITSCOPE_OCCLUSION     defined: what is close by keeps light away (occlusion.glsl); for samples of a refined picture
// HITSCOPE_CHANGE_MAP    defined: the colour is that of a quantity of change, softly lit (change_map.glsl)

#include "lighting.glsl"
#include "tone.glsl"
#include "change_map.glsl"
#ifdef HITSCOPE_SHADOWS
#include "shadow.glsl"
#endif
#ifdef HITSCOPE_ENVIRONMENT
#include "environment.glsl"
#endif
#ifdef HITSCOPE_MATCAP
#include "matcap.glsl"
#endif
#ifdef HITSCOPE_OCCLUSION
#include "occlusion.glsl"
#endif

in vec3 v_position;  // from the eye
in vec3 v_normal;
#ifdef HITSCOPE_TEXCOORDS
in vec2 v_texcoord;
#endif
#ifdef HITSCOPE_COLOURS
in vec3 v_colour;  // linear
#endif
#ifdef HITSCOPE_SHADOWS
in vec3 v_shadow;
#endif
#ifdef HITSCOPE_CUT_FILLED
#include "cut_fill.glsl"
#endif

uniform vec3 u_diffuse;
#ifndef HITSCOPE_METAL_ROUGHNESS
uniform vec3 u_specular;
uniform float u_shininess;
#endif
#ifdef HITSCOPE_TRANSLUCENT
uniform float u_opacity;
#endif
#ifdef HITSCOPE_TEXTURED
uniform sampler2D u_texture;
#endif
#ifdef HITSCOPE_METAL_ROUGHNESS
uniform vec2 u_metalRoughness;
#endif
#ifdef HITSCOPE_METAL_ROUGHNESS_MAP
uniform sampler2D u_metalRoughnessMap;  // green: roughness, blue: metalness
#endif
#ifdef HITSCOPE_MARKS
uniform vec4 u_rim;   // linear colour and strength of the selected target's rim
uniform vec4 u_ring;  // centre, from the eye, and radius of the highlighted hit; radius 0: none
uniform vec3 u_ringColour;
uniform float u_ringWidth;  // pixels
#endif

#ifdef HITSCOPE_CUT
const vec3 kInside = vec3(0.20, 0.27, 0.36);  // linear
#endif

#ifdef HITSCOPE_CUT_FILLED
uniform vec3 u_fillColour;  // sRGB
uniform float u_hatch;      // pixels
#endif

out vec4 o_colour;

#ifdef HITSCOPE_BACK_FACES
const vec3 kBackFace = vec3(0.55, 0.05, 0.16);  // linear; no clay or accent looks like it
#endif

vec3 facingNormal()
{
#ifdef HITSCOPE_FLAT
    vec3 across = normalize(cross(dFdx(v_position), dFdy(v_position)));
    return dot(across, sightTo(v_position)) > 0.0 ? -across : across;
#else
    vec3 normal = v_normal;
    if (dot(normal, normal) < 1.0e-12) {
        normal = cross(dFdx(v_position), dFdy(v_position));
        return dot(normal, sightTo(v_position)) > 0.0 ? -normalize(normal) : normalize(normal);
    }
    normal = normalize(normal);
    return gl_FrontFacing ? normal : -normal;
#endif
}

#ifdef HITSCOPE_CUT_FILLED
vec3 filling()
{
    float line = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / u_hatch) - 0.5) * u_hatch;
    return u_fillColour * mix(0.8, 1.0, smoothstep(0.5, 1.2, line));
}
#endif

#ifdef HITSCOPE_NORMAL_MAP
#include "normal_map.glsl"
#endif

#ifdef HITSCOPE_MARKS
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
#endif

void main()
{
#ifdef HITSCOPE_MARKS
    float ringed = ring();
#endif
    float opacity = 1.0;
#ifdef HITSCOPE_TRANSLUCENT
    opacity = u_opacity;
#endif
#ifdef HITSCOPE_CHANGE_MAP
    vec3 light = changeColour(abs(dot(facingNormal(), normalize(sightTo(v_position)))));
#ifdef HITSCOPE_MARKS
    light = mix(light, u_ringColour, ringed);
#endif
    o_colour = vec4(toSrgb(light), opacity);
#else
    vec3 albedo = u_diffuse;
#ifdef HITSCOPE_TEXTURED
    vec4 texel = texture(u_texture, vec2(v_texcoord.x, 1.0 - v_texcoord.y));
    albedo *= texel.rgb;
#endif
#ifdef HITSCOPE_COLOURS
    albedo *= v_colour;
#endif
#ifdef HITSCOPE_BACK_FACES
    albedo = gl_FrontFacing ? albedo : mix(albedo, kBackFace, 0.8);
#elif defined(HITSCOPE_CUT)
    albedo = gl_FrontFacing ? albedo : mix(albedo, kInside, 0.55);
#endif
    Surface surface;
    surface.position = v_position;
    surface.normal = facingNormal();
#ifdef HITSCOPE_NORMAL_MAP
    surface.normal = mappedNormal(surface.normal);
#endif
#ifdef HITSCOPE_METAL_ROUGHNESS
    vec2 metalRoughness = u_metalRoughness;
#ifdef HITSCOPE_METAL_ROUGHNESS_MAP
    metalRoughness *= texture(u_metalRoughnessMap, vec2(v_texcoord.x, 1.0 - v_texcoord.y)).bg;
#endif
    setMetalRoughness(surface, albedo, metalRoughness);
#else
    surface.diffuse = albedo;
    surface.specular = u_specular;
    surface.shininess = u_shininess;
#endif
    surface.sunlit = 1.0;
#ifdef HITSCOPE_SHADOWS
    surface.sunlit = sunlitShare(v_shadow);
#ifdef HITSCOPE_CUT
    surface.sunlit = gl_FrontFacing ? surface.sunlit : 1.0;
#endif
#endif

#ifdef HITSCOPE_MATCAP
    vec3 light = matcapLight(surface);
#elif defined(HITSCOPE_ENVIRONMENT)
    vec3 light = environmentLight(surface);
#else
    vec3 light = phong(surface);
#endif
#ifdef HITSCOPE_MARKS
    float grazing = 1.0 - abs(dot(surface.normal, normalize(sightTo(v_position))));
    light += u_rim.rgb * (u_rim.a * grazing * grazing * grazing);
    light = mix(light, u_ringColour, ringed);
#endif
    o_colour = vec4(display(light), opacity);
#ifdef HITSCOPE_OCCLUSION
    float open = openShare(surface.normal);
#ifdef HITSCOPE_MARKS
    open = mix(open, 1.0, ringed);
#endif
    o_colour.rgb *= open;
#endif
#endif
    // At the end: what is derived from neighbouring pixels needs all of them.
#ifdef HITSCOPE_CUT_FILLED
    if (isFilling()) {
        o_colour = vec4(filling(), 1.0);
        return;
    }
#endif
#if defined(HITSCOPE_TEXTURED) && !defined(HITSCOPE_CHANGE_MAP)
    if (texel.a < 0.5) {
        discard;
    }
#endif
}
