// SPDX-License-Identifier: GPL-3.0-or-later
// From linear light to what the framebuffer holds.

// Highlights roll off towards white instead of being cut; up to kShoulder light is left as it is.
vec3 softClip(vec3 light)
{
    const float kShoulder = 0.7;
    vec3 over = max(light - kShoulder, 0.0);
    return min(light, kShoulder) + (1.0 - kShoulder) * over / (over + (1.0 - kShoulder));
}

// IEC 61966-2-1.
vec3 toSrgb(vec3 light)
{
    vec3 low = 12.92 * light;
    vec3 high = 1.055 * pow(max(light, 0.0), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(light, vec3(0.0031308)));
}

vec3 display(vec3 light)
{
    return toSrgb(softClip(light));
}
