// SPDX-License-Identifier: GPL-3.0-or-later
// A surface in the light of a studio (view/environment.h): a table has what matte surfaces send back by their normal, and
// what is reflected by its direction and the roughness. The paper's terms of materials are taken as they are.

uniform sampler3D u_environment;  // octahedral maps: EnvironmentTable
uniform vec3 u_keyLight;          // unit, towards the light that casts shadows

const float kMapInner = 32.0;
const float kMapSide = 34.0;
const float kLayers = 7.0;
const float kInShadow = 0.45;  // of a matte surface's light, where it faces the key light and gets nothing of it

vec3 environmentAt(vec3 direction, float layer)
{
    vec3 d = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    vec2 folded = (1.0 - abs(d.zx)) * vec2(d.x < 0.0 ? -1.0 : 1.0, d.z < 0.0 ? -1.0 : 1.0);
    vec2 at = d.y < 0.0 ? folded : d.xz;
    vec2 texel = (0.5 * at + 0.5) * kMapInner + 1.0;
    return texture(u_environment, vec3(texel / kMapSide, (layer + 0.5) / kLayers)).rgb;
}

vec3 environmentLight(Surface s)
{
    vec3 toEye = -normalize(sightTo(s.position));
    vec3 mirrored = reflect(-toEye, s.normal);
    float facing = clamp(dot(s.normal, toEye), 0.0, 1.0);
    float towardsKey = max(dot(s.normal, u_keyLight), 0.0);
    float lit = 1.0 - (1.0 - s.sunlit) * (1.0 - kInShadow) * smoothstep(0.0, 0.4, towardsKey);
#ifdef HITSCOPE_METAL_ROUGHNESS
    float roughness = s.roughness;
    // How much is reflected: B. Karis, "Physically based shading on mobile", 2014.
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * facing)) * r.x + r.y;
    vec3 reflected = s.specular * (-1.04 * a + r.z) + (1.04 * a + r.w);
#else
    // A highlight of Phong's exponent is as wide as one of this roughness: B. Walter et al., EGSR 2007.
    float roughness = sqrt(sqrt(2.0 / (s.shininess + 2.0)));
    float grazing = 1.0 - facing;
    vec3 reflected = 0.12 * s.specular + 0.10 * grazing * grazing * grazing * grazing;
#endif
    return lit * (s.diffuse * environmentAt(s.normal, 0.0) +
                  max(reflected, 0.0) * environmentAt(mirrored, 1.0 + roughness * (kLayers - 2.0)));
}
