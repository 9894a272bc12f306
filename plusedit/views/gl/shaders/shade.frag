// Light on surfaces: a soft key light from the upper left that goes with the camera, a fill light,
// sky above and ground below; or, as a second style, a studio mirrored in a smooth coat.
//
// Squares stand for the curve between colors and light: they are much quicker than the exact one,
// and nobody sees the difference as long as both ways agree.

in vec3 sight;
in vec3 normal;
#ifdef TINTED
in vec3 tint;
#endif
#ifdef WIRE
in vec2 cell;
uniform vec4 wire;
uniform float ratio;
#endif

uniform vec4 front;     // how much light is thrown back, and the opacity
uniform vec4 back;
uniform vec3 up;        // of the world, in the axes of the view
uniform float parallel; // 1 in parallel projection, else 0

out vec4 color;

const vec3 KEY = vec3(-0.474, 0.632, 0.612);
const vec3 FILL = vec3(0.857, -0.171, 0.486);
const float DARKEST = 0.011, BRIGHTEST = 0.88;

#ifdef MATCAP
vec3 lit(vec3 albedo, vec3 n, vec3 v) {
    vec3 r = reflect(-v, n);
    float high = smoothstep(0.15, 0.85, r.y);
    float box = smoothstep(0.50, 0.62, r.y) * smoothstep(0.98, 0.86, r.y);
    float strip = smoothstep(0.42, 0.50, -r.x) * smoothstep(0.86, 0.74, -r.x);
    float rim = 1.0 - max(0.0, dot(n, v));
    vec3 light = vec3(0.15, 0.15, 0.165) + 0.42 * max(0.0, dot(n, KEY)) + 0.16 * high;
    return albedo * light + 0.14 * box + 0.08 * strip + 0.05 * rim * rim * rim;
}
#else
vec3 lit(vec3 albedo, vec3 n, vec3 v) {
    float key = max(0.0, 0.8 * dot(n, KEY) + 0.2);
    float fill = max(0.0, dot(n, FILL));
    vec3 light = mix(vec3(0.16, 0.155, 0.15), vec3(0.29, 0.305, 0.33), 0.5 + 0.5 * dot(n, up));
    light += key * key * vec3(0.78, 0.765, 0.735) + fill * vec3(0.10, 0.11, 0.13);
    float gloss = max(0.0, 2.0 * dot(n, v) * dot(n, KEY) - dot(v, KEY));
    gloss *= gloss;
    gloss *= gloss;
    return albedo * light + 0.07 * gloss * gloss * gloss;
}
#endif

#ifdef STRIPES
uniform float stripes; // pairs of bands over half a turn
uniform vec3 light;    // toward it, in the axes of the view
#ifdef REFLECTION
uniform mat3 axes;
#endif

const float TURN = 3.14159265;
const float DARK = 0.10, BRIGHT = 0.90;

// How far along its pair of bands a place is, and how much of one a pixel takes.
vec2 band_of(vec3 n, vec3 v) {
#ifdef REFLECTION
    // The angle around the x axis of the world; by its gradient, as the angle itself jumps.
    vec2 r = (transpose(axes) * reflect(-v, n)).yz;
    float square = max(dot(r, r), 1e-6);
    vec2 dx = dFdx(r), dy = dFdy(r);
    float each = (abs(r.x * dx.y - r.y * dx.x) + abs(r.x * dy.y - r.y * dy.x)) / square;
    return vec2(atan(r.y, r.x), each) * stripes / TURN;
#else
#ifdef ZEBRA
    float height = reflect(-v, n).y;
#else
    float height = dot(n, light);
#endif
    float each = fwidth(height) * inversesqrt(max(1.0 - height * height, 1e-4));
    return vec2(acos(clamp(height, -1.0, 1.0)), each) * stripes / TURN;
#endif
}

// The share of light in a pixel: where bands crowd, the mean of all.
float striped(vec3 n, vec3 v) {
#ifdef REFLECTION
    const float half_dark = 0.42;
#else
    const float half_dark = 0.25;
#endif
    vec2 band = band_of(n, v);
    float off = abs(fract(band.x) - 0.5); // from the middle of a dark one
    float share = clamp(0.5 + (off - half_dark) / max(band.y, 1e-6), 0.0, 1.0);
    return mix(share, 1.0 - 2.0 * half_dark, smoothstep(0.4, 1.0, band.y));
}
#endif

void main() {
    vec3 v = parallel > 0.5 ? vec3(0.0, 0.0, 1.0) : -normalize(sight);
    // Where there is no normal, as at the tip of a cone, that of the facet stands in.
    vec3 n = dot(normal, normal) > 1e-6 ? (gl_FrontFacing ? normal : -normal)
                                        : cross(dFdx(sight), dFdy(sight));
    n = normalize(n);
    // At an outline the smooth normal may look away though its facet is seen.
    float facing = dot(n, v);
    n += max(0.0, 0.01 - facing) * v;

    vec4 side = gl_FrontFacing ? front : back;
#ifdef TINTED
    side.rgb = tint * tint;
#endif
    vec3 shown = sqrt(clamp(lit(side.rgb, n, v), DARKEST, BRIGHTEST));
#ifdef TINTED
    // Colors that are to be compared with a legend are not left in the shade.
    shown = mix(shown, tint, 0.45);
#endif
#if defined(STRIPES) && !defined(GLASS)
    // Form is still seen: what is light or dark is so with the light that falls on it.
    float glow = 0.75 + 0.25 * sqrt(lit(vec3(1.0), n, v).g);
    shown = mix(shown * 0.18 + DARK, vec3(BRIGHT) * glow, striped(n, v));
#endif
    float alpha = side.a;
#ifdef GLASS
    // It is lit from within as well, and denser where it is seen along its surface.
    float rim = 1.0 - abs(facing);
    shown = mix(shown, sqrt(side.rgb), 0.5);
    alpha += (1.0 - alpha) * 0.3 * rim * rim;
#endif
#ifdef WIRE
    vec2 step_of = max(fwidth(cell), 1e-9);
    vec2 off = abs(fract(cell - 0.5) - 0.5) / step_of;
    // Where lines crowd, they become a tint instead of a pattern.
    vec2 room = smoothstep(1.5 * ratio, 5.0 * ratio, 1.0 / step_of);
    vec2 on = clamp(0.5 * ratio + 0.5 - off, 0.0, 1.0) * mix(vec2(0.25), vec2(1.0), room);
    float line = max(on.x, on.y) * wire.a;
    shown = mix(shown, wire.rgb, line);
    alpha = max(alpha, line);
#endif
    color = vec4(shown, 1.0) * alpha;
}
