// SPDX-License-Identifier: GPL-3.0-or-later
// Phong lighting by the paper's equations 7-14: a directional light, four point lights, a spotlight at the eye.
// All positions are in the world, metres; all colours linear.
//
// HITSCOPE_MATTE   defined: the surface has no specular colour, so none is worked out

struct LightColours {
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
};

struct Surface {
    vec3 position;
    vec3 normal;  // unit, towards the eye
    vec3 diffuse;
    vec3 specular;
    float shininess;
};

uniform vec3 u_eye;
uniform vec3 u_eyeDirection;  // unit

uniform int u_directionalOn;
uniform vec3 u_directionalDirection;  // unit, the way the light travels
uniform LightColours u_directionalColours;

uniform int u_pointOn[4];
uniform vec3 u_pointPosition[4];
uniform vec3 u_pointAttenuation[4];  // constant, linear, quadratic
uniform LightColours u_pointColours[4];

uniform int u_spotOn;
uniform vec3 u_spotAttenuation;
uniform vec2 u_spotCosines;  // of the inner and the outer angle
uniform LightColours u_spotColours;

// What does not depend on the light: dot(toEye, reflect(-toLight, n)) of equation 9 is the same number as
// dot(toLight, reflect(-toEye, n)), and that reflection is needed only once.
struct View {
    vec3 toEye;  // unit
    float distance;
    vec3 mirrored;  // unit
};

// Equations 8-11; toLight is a unit vector. The specular term needs a lit side, or it would shine through.
vec3 diffuseAndSpecular(LightColours light, Surface s, View view, vec3 toLight)
{
    float diff = max(dot(s.normal, toLight), 0.0);
#ifdef HITSCOPE_MATTE
    return light.diffuse * diff * s.diffuse;
#endif
    float spec = diff > 0.0 ? pow(max(dot(toLight, view.mirrored), 1.0e-6), s.shininess) : 0.0;
    return light.diffuse * diff * s.diffuse + light.specular * spec * s.specular;
}

// Equations 12 and 13.
float attenuation(vec3 factors, float d)
{
    return 1.0 / max(factors.x + factors.y * d + factors.z * d * d, 1.0e-4);
}

vec3 pointLight(int i, Surface s, View view)
{
    vec3 way = u_pointPosition[i] - s.position;
    float d = max(length(way), 1.0e-6);
    vec3 reflected = diffuseAndSpecular(u_pointColours[i], s, view, way / d);
    return attenuation(u_pointAttenuation[i], d) * (u_pointColours[i].ambient * s.diffuse + reflected);
}

vec3 spotLight(Surface s, View view)
{
    // Equation 14, with cosines for angles: one inside the inner cone, zero outside the outer.
    float theta = dot(view.toEye, -u_eyeDirection);
    float cone = max(u_spotCosines.x - u_spotCosines.y, 1.0e-4);
    float intensity = clamp((theta - u_spotCosines.y) / cone, 0.0, 1.0);
    vec3 reflected = intensity * diffuseAndSpecular(u_spotColours, s, view, view.toEye);
    return attenuation(u_spotAttenuation, view.distance) * (u_spotColours.ambient * s.diffuse + reflected);
}

// Equation 7, summed over the lights that are on. The diffuse colour stands for the ambient one too, as in the
// paper's source [1]: files rarely have a Ka that means anything.
vec3 phong(Surface s)
{
    View view;
    vec3 way = u_eye - s.position;
    view.distance = max(length(way), 1.0e-6);
    view.toEye = way / view.distance;
    view.mirrored = reflect(-view.toEye, s.normal);

    vec3 light = vec3(0.0);
    if (u_directionalOn != 0) {
        light += u_directionalColours.ambient * s.diffuse +
                 diffuseAndSpecular(u_directionalColours, s, view, -u_directionalDirection);
    }
    for (int i = 0; i < 4; ++i) {
        if (u_pointOn[i] != 0) {
            light += pointLight(i, s, view);
        }
    }
    if (u_spotOn != 0) {
        light += spotLight(s, view);
    }
    return light;
}
