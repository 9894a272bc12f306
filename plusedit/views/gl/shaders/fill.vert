// Areas of one color.

layout(location = 0) in vec3 at;
layout(location = 1) in vec4 color;

uniform mat4 world_to_clip;
uniform vec4 crop;
uniform vec2 pull;

flat out vec4 ink;

void main() {
    vec4 clip = world_to_clip * vec4(at, 1.0);
    clip.z += pull.x + pull.y * clip.w;
    gl_Position = vec4(clip.xy * crop.xy + crop.zw * clip.w, clip.zw);
    ink = color;
}
