// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity of change as a colour. HITSCOPE_CHANGE_MAP: defined.

#ifdef HITSCOPE_CHANGE_MAP
in float v_change;

uniform sampler2D u_changeColours;  // a row of 256, sRGB
uniform vec2 u_changeRange;         // the values of its ends
uniform float u_isolineStep;        // between two isolines; 0: none
uniform float u_isolineWidth;       // pixels

// [0, 1]: how much of this pixel an isoline covers. They fade where they would lie closer than they are wide.
float isoline()
{
    if (u_isolineStep <= 0.0) {
        return 0.0;
    }
    float at = v_change / u_isolineStep;
    float pixel = fwidth(at);
    if (pixel <= 1.0e-9) {
        return 0.0;  // the same value all over
    }
    float off = abs(fract(at + 0.5) - 0.5) / pixel;
    float line = 1.0 - smoothstep(0.5 * u_isolineWidth - 0.5, 0.5 * u_isolineWidth + 0.5, off);
    return line * (1.0 - smoothstep(0.15, 0.45, pixel * u_isolineWidth));
}

// Linear. Lit from the eye only, softly: the shape is seen, and where the surface faces the eye the colour is the map's
// own.
vec3 changeColour(float facing)
{
    float at = clamp((v_change - u_changeRange.x) / (u_changeRange.y - u_changeRange.x), 0.0, 1.0);
    vec3 colour = texture(u_changeColours, vec2((at * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    float bright = dot(colour, vec3(0.2126, 0.7152, 0.0722));
    vec3 line = bright > 0.25 ? vec3(0.0) : vec3(1.0);
    return mix(colour, line, 0.65 * isoline()) * mix(0.35, 1.0, facing);
}
#endif
