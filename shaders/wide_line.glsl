// SPDX-License-Identifier: GPL-3.0-or-later
// A line of constant width as two triangles: wide lines are not for core profiles to draw.

uniform vec2 u_halfSize;  // of the picture, pixels
uniform float u_reach;    // pixels from the line's middle to the triangles' edge: half its width and a pixel of fade

// Cuts the line off at the near plane, where it has no direction in the picture any more, and what belongs to its
// ends with them. False: nothing is left.
bool clipLine(inout vec4 a, inout vec4 b, inout float ofA, inout float ofB)
{
    float before = a.z + a.w;
    float behind = b.z + b.w;
    if (before <= 0.0 && behind <= 0.0) {
        return false;
    }
    if (before < 0.0) {
        float at = before / (before - behind) + 1.0e-6;
        a = mix(a, b, at);
        ofA = mix(ofA, ofB, at);
    } else if (behind < 0.0) {
        float at = behind / (behind - before) + 1.0e-6;
        b = mix(b, a, at);
        ofB = mix(ofB, ofA, at);
    }
    return a.w > 0.0 && b.w > 0.0;
}

bool clipLine(inout vec4 a, inout vec4 b)
{
    float nothing = 0.0;
    return clipLine(a, b, nothing, nothing);
}

// Clip space: what takes the line's end to the edge of its width, to be scaled with w; a longer line by its width.
void lineSides(vec4 a, vec4 b, out vec2 along, out vec2 across)
{
    vec2 way = (b.xy / b.w - a.xy / a.w) * u_halfSize;
    float size = length(way);
    way = size > 1.0e-4 ? way / size : vec2(1.0, 0.0);
    along = way / u_halfSize * 0.5;
    across = u_reach * vec2(-way.y, way.x) / u_halfSize;
}
