// SPDX-License-Identifier: GPL-3.0-or-later
// A tangent-space normal map on whatever the surface has become: the tangents are found from how place and texture
// coordinates change from pixel to pixel, so that dents need no tangents of their own (C. Schueler, "Normal mapping
// without precomputed tangents", ShaderX 5).

uniform sampler2D u_normalMap;    // red along u, green along v (upwards), blue outwards; [0, 1] for [-1, 1]
uniform float u_normalStrength;   // scales red and green

// normal: unit, towards the eye.
vec3 mappedNormal(vec3 normal)
{
    vec3 texel = texture(u_normalMap, vec2(v_texcoord.x, 1.0 - v_texcoord.y)).rgb * (255.0 / 127.0) - (128.0 / 127.0);
    texel.xy *= u_normalStrength;
    vec3 alongX = dFdx(v_position);
    vec3 alongY = dFdy(v_position);
    vec2 textureX = dFdx(v_texcoord);
    vec2 textureY = dFdy(v_texcoord);
    vec3 acrossY = cross(alongY, normal);
    vec3 acrossX = cross(normal, alongX);
    vec3 tangent = acrossY * textureX.x + acrossX * textureY.x;
    vec3 bitangent = acrossY * textureX.y + acrossX * textureY.y;
    float longest = max(dot(tangent, tangent), dot(bitangent, bitangent));
    if (longest < 1.0e-30) {
        return normal;  // no texture coordinates, or the same all over
    }
    float size = inversesqrt(longest);
    vec3 mapped = normalize(texel.x * size * tangent + texel.y * size * bitangent + texel.z * normal);
    // What the map turns away from the eye would be lit from behind.
    vec3 sight = sightTo(v_position);
    float away = dot(mapped, sight);
    return away > 0.0 ? normalize(mapped - (away / dot(sight, sight) + 1.0e-4) * sight) : mapped;
}
