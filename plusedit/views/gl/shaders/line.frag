// Round ends and corners, smooth edges. DASHED are lines of which some are dashed or dotted;
// FADING are straight ones that fade with the distance from a place.

in vec2 place;
flat in vec4 ink;
flat in vec4 measure;
flat in vec4 cuts;
#ifdef FADING
in vec4 trace;
uniform vec4 fading;
#endif

uniform float ratio;
uniform float opacity;

out vec4 color;

void main() {
    float reach = measure.x, radius = measure.y;
#ifdef FADING
    float off = abs(place.y);
#else
    // A pixel where two segments meet belongs to one of them: what lies beyond the line that halves
    // the corner is the neighbor's. Inside of corners only lines that let through are so strict, as
    // in bends tighter than they are wide it leaves holes.
    bool strict_too = ink.a * opacity < 1.0;
    bool before = dot(place, cuts.xy) < 0.0 && (place.x < 0.0 || strict_too);
    bool after = dot(place - vec2(reach, 0.0), cuts.zw) > 0.0 && (place.x > reach || strict_too);
    if (before || after) discard;
    float off = length(vec2(place.x - clamp(place.x, 0.0, reach), place.y));
#endif
    // What is thinner than a pixel covers it in part.
    float cover = clamp(radius + 0.5 - off, 0.0, min(1.0, 2.0 * radius));
#ifdef DASHED
    if (measure.w > 0.5) {
        vec2 dash = ratio * (measure.w < 1.5 ? vec2(6.0, 10.0) : vec2(2.0, 5.0));
        float phase = mod(measure.z + place.x, dash.y);
        float inside = max(min(phase, dash.x - phase), phase - dash.y);
        cover *= clamp(0.5 + inside, 0.0, 1.0);
    }
#endif
#ifdef FADING
    vec3 there = trace.xyz / (trace.w * fading.w);
    float left = clamp(1.25 * (1.0 - dot(there, there)), 0.0, 1.0);
    cover *= left * left;
#endif
    float alpha = ink.a * cover * opacity;
    if (alpha < 0.02) discard;
    color = vec4(ink.rgb, 1.0) * alpha;
}
