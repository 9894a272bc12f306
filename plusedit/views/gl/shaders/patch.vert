// A plus surface: every term and its derivatives by u and by v, weighed by s.

layout(location = 0) in vec3 base;
layout(location = 1) in vec3 plus;
layout(location = 2) in vec3 base_u;
layout(location = 3) in vec3 plus_u;
layout(location = 4) in vec3 base_v;
layout(location = 5) in vec3 plus_v;
layout(location = 6) in vec2 where; // which sample, by u and by v
#ifdef TINTED
layout(location = 7) in vec3 color_at;
out vec3 tint;
#endif

uniform float s;
uniform float least; // length of a tangent below which it has no direction
uniform mat4 world_to_clip;
uniform mat3 axes;   // of the view
uniform vec3 eye;    // in the axes of the view; from the origin of this patch
uniform vec4 crop;

out vec3 sight;  // from the eye to the point, in the axes of the view
out vec3 normal; // likewise; zero where the surface has none
#ifdef WIRE
out vec2 cell;
#endif

vec3 way(vec3 tangent) {
    float reach = max(abs(tangent.x), max(abs(tangent.y), abs(tangent.z)));
    return reach > least ? normalize(tangent / reach) : vec3(0.0);
}

void main() {
    vec3 at = base + s * plus;
    vec3 across = cross(way(base_u + s * plus_u), way(base_v + s * plus_v));
    float slant = length(across);
    normal = slant > 1e-4 ? axes * (across / slant) : vec3(0.0);
    sight = axes * at - eye;
#ifdef TINTED
    tint = color_at;
#endif
#ifdef WIRE
    cell = where;
#endif
    vec4 clip = world_to_clip * vec4(at, 1.0);
    gl_Position = vec4(clip.xy * crop.xy + crop.zw * clip.w, clip.zw);
}
