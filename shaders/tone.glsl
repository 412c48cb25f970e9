// SPDX-License-Identifier: GPL-3.0-or-later
// From linear light to what the framebuffer holds.

// Highlights roll off towards white instead of being cut; up to kShoulder light is left as it is.
vec3 softClip(vec3 light)
{
    const float kShoulder = 0.7;
    vec3 over = max(light - kShoulder, 0.0);
    return min(light, kShoulder) + (1.0 - kShoulder) * over / (over + (1.0 - kShoulder));
}

// IEC 61966-2-1, with its power fitted by roots: at most 0.1 of a step of eight bits away, and faster on a CPU.
vec3 toSrgb(vec3 light)
{
    vec3 low = 12.92 * light;
    vec3 root = sqrt(max(light, 0.0));
    vec3 high = 0.83375549 * root + 0.29810672 * sqrt(root) - 0.0553183 * light - 0.0769034;
    return mix(high, low, lessThanEqual(light, vec3(0.0031308)));
}

vec3 display(vec3 light)
{
    return toSrgb(softClip(light));
}
