// Triangles with normals, or zero for flat ones.

layout(location = 0) in vec3 at;
layout(location = 1) in vec3 across;
#ifdef TINTED
layout(location = 2) in vec3 color_at;
out vec3 tint;
#endif

uniform mat4 world_to_clip;
uniform mat3 axes;
uniform vec3 eye;
uniform vec4 crop;

out vec3 sight;
out vec3 normal;

void main() {
    normal = axes * across;
#ifdef TINTED
    tint = color_at;
#endif
    sight = axes * at - eye;
    vec4 clip = world_to_clip * vec4(at, 1.0);
    gl_Position = vec4(clip.xy * crop.xy + crop.zw * clip.w, clip.zw);
}
