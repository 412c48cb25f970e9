// SPDX-License-Identifier: GPL-3.0-or-later
// What of a colour (sRGB) tells whether samples differ. No channel goes without being noticed.
float brightness(vec3 colour)
{
    return dot(colour, vec3(0.3, 0.4, 0.3));
}
