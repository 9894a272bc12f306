// One segment of a line for each instance: a box on the screen around its two ends.

layout(location = 0) in vec4 before;  // places in the world; w: 0 solid, 1 dashed, 2 dotted,
layout(location = 1) in vec4 start;   // -1 for a gap between lines, -2 for where a closed one goes on
layout(location = 2) in vec4 end;
layout(location = 3) in vec4 after;
layout(location = 4) in vec4 color;
layout(location = 5) in vec2 form;    // width, and pixels of the line before this segment

uniform mat4 world_to_clip;
uniform vec2 size;   // of the picture in pixels of the device
uniform vec4 crop;   // factor and shift of the part of it that is drawn
uniform vec2 pull;   // depth of a logical pixel: over w, and by itself
uniform float ratio; // pixels of the device to a logical one

#ifdef FADING
uniform vec4 fading;      // a place, and the distance from it at which lines are gone
out vec4 trace;           // from that place; and one: both over w
#endif
out vec2 place;           // along and across the segment, pixels from its start
flat out vec4 ink;
flat out vec4 measure;    // length, half the width, pixels before, kind
flat out vec4 cuts;       // where the segments before and after take over

vec2 pixel_of(vec4 at) {
    return (at.xy / at.w * 0.5 + 0.5) * size;
}

// The line that halves the corner between two directions, as seen along the second.
vec2 halving(vec2 first, vec2 second) {
    vec2 sum = first + second;
    return vec2(dot(sum, second), first.y * second.x - first.x * second.y);
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
#ifdef FADING
    trace = vec4(1.0);
#endif
    place = vec2(0.0); ink = vec4(0.0); measure = vec4(1.0); cuts = vec4(0.0);
    if (start.w < 0.0 || end.w < 0.0) return;
    vec4 a = world_to_clip * vec4(start.xyz, 1.0), b = world_to_clip * vec4(end.xyz, 1.0);
    float near_a = a.z + a.w, near_b = b.z + b.w;
    if (near_a <= 0.0 && near_b <= 0.0) return;
    float since = near_a < 0.0 ? near_a / (near_a - near_b) : 0.0;
    float until = near_b < 0.0 ? near_a / (near_a - near_b) : 1.0;
    vec4 whole = b - a;
    b = a + until * whole;
    a += since * whole;
    vec2 from = pixel_of(a), to = pixel_of(b);
    float reach = length(to - from);
    vec2 along = reach > 1e-4 ? (to - from) / reach : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);

    float radius = 0.5 * form.x * ratio;
    bool is_end = gl_VertexID > 1;
    float side = (gl_VertexID & 1) == 1 ? 1.0 : -1.0;
    place = vec2(is_end ? reach + radius + 0.5 : -radius - 0.5, side * (radius + 0.5));
    vec2 at = from + place.x * along + place.y * across;
    vec4 clip = is_end ? b : a;
    // In front of the surface it lies on, and of thinner lines that run along with it.
    float depth = clip.z / clip.w + (1.0 + form.x) * (pull.x / clip.w + pull.y);
    gl_Position = vec4((at / size * 2.0 - 1.0) * crop.xy + crop.zw, depth, 1.0);

#ifdef FADING
    // Over w all of it is linear on the screen.
    vec3 there = is_end ? mix(start.xyz, end.xyz, until) : mix(start.xyz, end.xyz, since);
    trace = vec4(there - fading.xyz, 1.0) / clip.w;
#endif
    ink = color;
    measure = vec4(reach, radius, form.y * ratio, start.w);
    vec4 p = world_to_clip * vec4(before.xyz, 1.0), q = world_to_clip * vec4(after.xyz, 1.0);
    vec2 step_in = from - pixel_of(p), step_out = pixel_of(q) - to;
    if (before.w != -1.0 && p.w > 0.0 && length(step_in) > 1e-4)
        cuts.xy = halving(normalize(step_in), along);
    if (after.w != -1.0 && q.w > 0.0 && length(step_out) > 1e-4)
        cuts.zw = halving(normalize(step_out), along);
}
