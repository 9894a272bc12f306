// One mark for each instance: a square on the screen around a point.

layout(location = 0) in vec3 at;
layout(location = 1) in vec4 fill;
layout(location = 2) in vec4 outline;
layout(location = 3) in vec3 form; // size, width of the outline, kind

uniform mat4 world_to_clip;
uniform vec2 size;
uniform vec4 crop;
uniform vec2 pull;
uniform float ratio;

out vec2 place;       // pixels from the point, to the right and upwards
flat out vec4 body;
flat out vec4 edge;
flat out vec3 measure; // half the size, width, kind

void main() {
    vec4 clip = world_to_clip * vec4(at, 1.0);
    float radius = 0.5 * form.x * ratio;
    place = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0) * (radius + 1.0);
    body = fill;
    edge = outline;
    measure = vec3(radius, form.y * ratio, form.z);
    // A mark stands in front of lines that end in it, by as much as a ball would.
    float depth = clip.z / clip.w + (2.0 + 0.5 * form.x) * (pull.x / clip.w + pull.y);
    vec2 pixel = (clip.xy / clip.w * 0.5 + 0.5) * size;
    // In pixels of the device a mark of whole size is as crisp as its point allows.
    vec2 ndc = (pixel + place) / size * 2.0 - 1.0;
    gl_Position = vec4(ndc * crop.xy + crop.zw, depth, 1.0);
    if (clip.z < -clip.w) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
