// Triangles with normals, or zero for flat ones.

layout(location = 0) in vec3 at;
layout(location = 1) in vec3 across;

uniform mat4 world_to_clip;
uniform mat3 axes;
uniform vec3 eye;
uniform vec4 crop;

out vec3 sight;
out vec3 normal;

void main() {
    normal = axes * across;
    sight = axes * at - eye;
    vec4 clip = world_to_clip * vec4(at, 1.0);
    gl_Position = vec4(clip.xy * crop.xy + crop.zw * clip.w, clip.zw);
}
