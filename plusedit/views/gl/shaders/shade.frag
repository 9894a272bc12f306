// Light on surfaces: a soft key light from the upper left that goes with the camera, a fill light,
// sky above and ground below; or, as a second style, a studio mirrored in a smooth coat.

in vec3 sight;
in vec3 normal;
in vec2 cell;

uniform vec4 front;
uniform vec4 back;
uniform vec4 wire;         // color of lines between samples; alpha 0 for none
uniform vec3 up;           // of the world, in the axes of the view
uniform float parallel;    // 1 in parallel projection, else 0
uniform float ratio;
uniform float opacity;
uniform int style;         // 0 studio, 1 matcap

out vec4 color;

const vec3 KEY = vec3(-0.474, 0.632, 0.612);
const vec3 FILL = vec3(0.857, -0.171, 0.486);

vec3 linear_of(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

vec3 seen_as(vec3 c) {
    return mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 studio(vec3 albedo, vec3 n, vec3 v) {
    float key = max(0.0, (dot(n, KEY) + 0.25) / 1.25);
    float fill = max(0.0, dot(n, FILL));
    float sky = 0.5 + 0.5 * dot(n, up);
    vec3 light = mix(vec3(0.12, 0.115, 0.11), vec3(0.25, 0.265, 0.29), sky);
    light += key * key * vec3(0.78, 0.765, 0.735) + fill * vec3(0.10, 0.11, 0.13);
    float gloss = pow(max(0.0, dot(n, normalize(KEY + v))), 48.0);
    return albedo * light + 0.07 * gloss;
}

vec3 matcap(vec3 albedo, vec3 n, vec3 v) {
    vec3 r = reflect(-v, n);
    float high = smoothstep(0.15, 0.85, r.y), box = smoothstep(0.50, 0.62, r.y) * smoothstep(0.98, 0.86, r.y);
    float strip = smoothstep(0.42, 0.50, -r.x) * smoothstep(0.86, 0.74, -r.x);
    float rim = pow(1.0 - max(0.0, dot(n, v)), 3.0);
    vec3 light = vec3(0.15, 0.15, 0.165) + 0.42 * max(0.0, dot(n, KEY)) + 0.16 * high;
    return albedo * light + 0.14 * box + 0.08 * strip + 0.05 * rim;
}

// How much of a pixel the lines at whole numbers of `at` cover, `width` pixels wide.
vec2 lines(vec2 at, float width) {
    vec2 step_of = max(fwidth(at), 1e-9);
    vec2 off = abs(fract(at - 0.5) - 0.5) / step_of;
    // Where lines crowd, they become a tint instead of a pattern.
    vec2 room = smoothstep(1.5 * width, 5.0 * width, 1.0 / step_of);
    return clamp(0.5 * width + 0.5 - off, 0.0, 1.0) * mix(vec2(0.25), vec2(1.0), room);
}

void main() {
    vec3 flat_normal = cross(dFdx(sight), dFdy(sight));
    vec3 v = parallel > 0.5 ? vec3(0.0, 0.0, 1.0) : -normalize(sight);
    vec3 n = normal;
    float reach = length(n);
    if (reach > 1e-3) {
        n /= reach;
        if (!gl_FrontFacing) n = -n;
    } else {
        n = normalize(flat_normal);
    }
    // At an outline the smooth normal may look away though its facet is seen.
    float facing = dot(n, v);
    if (facing < 0.0) n = normalize(n - (facing - 0.01) * v);

    vec4 side = gl_FrontFacing ? front : back;
    vec3 albedo = linear_of(side.rgb);
    vec3 lit = seen_as(clamp(style == 1 ? matcap(albedo, n, v) : studio(albedo, n, v), 0.012, 0.93));
    float alpha = side.a;
    if (alpha < 1.0) alpha = mix(alpha, 1.0, 0.45 * pow(1.0 - abs(dot(n, v)), 2.0));
    if (wire.a > 0.0) {
        vec2 on = lines(cell, ratio);
        float line = max(on.x, on.y) * wire.a;
        lit = mix(lit, wire.rgb, line);
        alpha = max(alpha, line);
    }
    color = vec4(lit, 1.0) * (alpha * opacity);
}
