// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the directional light arrives.
//
// HITSCOPE_SHADOW_TAPS   looks into the shadow map for a pixel, each the mean of four texels: 1, 4 or 9

uniform sampler2DShadow u_shadowMap;
#if HITSCOPE_SHADOW_TAPS > 1
uniform float u_shadowSpread;  // texture coordinates from one look to the next
#endif

// at: texture coordinates and depth in the shadow map; what lies outside of it is lit.
float sunlitShare(vec3 at)
{
#if HITSCOPE_SHADOW_TAPS == 1
    return texture(u_shadowMap, at);
#elif HITSCOPE_SHADOW_TAPS == 4
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 off = vec2((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5);
        lit += texture(u_shadowMap, vec3(at.xy + u_shadowSpread * off, at.z));
    }
    return 0.25 * lit;
#else
    float lit = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            lit += texture(u_shadowMap, vec3(at.xy + u_shadowSpread * vec2(x, y), at.z));
        }
    }
    return lit / 9.0;
#endif
}
