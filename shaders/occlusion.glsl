// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the light around arrives where something close by stands in its way: ambient obscurance in screen space,
// after M. McGuire, M. Mara and D. Luebke, "Scalable ambient obscurance", HPG 2012, section 2.3. A picture's depths
// say what is close by. Each sample of a refined picture looks at a few places of its own; their mean is smooth.
//
// HITSCOPE_ORTHOGRAPHIC   defined: the camera has no eye
// HITSCOPE_ALIKE          defined: all pixels look at the same places around them

uniform sampler2D u_nearDepths;      // of the same picture, with no jitter
uniform mat3 u_toView;               // from the world's axes to those of the picture: right, up, towards the eye
uniform vec4 u_nearPlace;            // half the picture's size, and how far this sample is off, pixels
uniform vec4 u_nearScale;            // metres a pixel (a metre from the eye), the projection's two terms of depth, radius
uniform vec2 u_nearTurn;             // [0, 1): turns and shifts the places of this sample

const int kPlaces = 4;
const float kStrength = 1.15;
const float kLeastOpen = 0.12;
#ifdef HITSCOPE_ALIKE
const float kOwnShare = 0.0;
#else
const float kOwnShare = 0.0625;  // of a turn
#endif
const mat2 kGoldenTurn = mat2(-0.737369, 0.675490, -0.675490, -0.737369);

// From the depth buffer to metres from the eye along the line of sight.
float awayFrom(float depth)
{
    float z = 2.0 * depth - 1.0;
#ifdef HITSCOPE_ORTHOGRAPHIC
    return (u_nearScale.z - z) / u_nearScale.y;
#else
    return u_nearScale.z / (z + u_nearScale.y);
#endif
}

float metresAPixel(float away)
{
#ifdef HITSCOPE_ORTHOGRAPHIC
    return u_nearScale.x;
#else
    return u_nearScale.x * away;
#endif
}

// at: in pixels of the picture with no jitter; depth: there; normal: unit, world, towards the eye; turn: a sample's.
float openShareAt(vec2 at, float depth, vec3 normal, vec2 turn)
{
    float away = awayFrom(depth);
    float pixel = metresAPixel(away);
    vec3 here = vec3((at - u_nearPlace.xy) * pixel, -away);
    vec3 n = u_toView * normal;
    float perRadius = 1.0 / u_nearScale.w;
    float reach = min(u_nearScale.w / pixel, u_nearPlace.y);  // pixels
    // A little off in each pixel: with wholly other directions so few samples leave stripes.
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float angle = 6.2831853 * (noise * kOwnShare + turn.x);
    float shift = fract(noise * kOwnShare + turn.y);
    vec2 way = vec2(cos(angle), sin(angle));
    ivec2 last = ivec2(2.0 * u_nearPlace.xy) - 1;
    float slack = (0.01 * u_nearScale.w + 1.5 * pixel) * perRadius;
    float sum = 0.0;
    for (int i = 0; i < kPlaces; ++i) {
        float share = (float(i) + shift) / float(kPlaces);
        ivec2 place = clamp(ivec2(at + way * (1.5 + reach * share)), ivec2(0), last);
        float there = awayFrom(texelFetch(u_nearDepths, place, 0).r);
        vec2 middle = vec2(place) + 0.5 - u_nearPlace.xy;
        vec3 to = (vec3(middle * metresAPixel(there), -there) - here) * perRadius;
        float squared = dot(to, to);
        float near = max(1.0 - squared, 0.0);
        sum += near * near * near * max(dot(to, n) - slack, 0.0) / (squared + 0.01);
        way = kGoldenTurn * way;
    }
    // Where the radius is a pixel or two nothing can be told.
    float known = smoothstep(2.0, 6.0, reach);
    return max(1.0 - known * kStrength * (5.0 / float(kPlaces)) * sum, kLeastOpen);
}

float openShare(vec3 normal)
{
    return openShareAt(gl_FragCoord.xy - u_nearPlace.zw, gl_FragCoord.z, normal, u_nearTurn);
}
