// Circles, squares, diamonds, rings and crosses by their distance functions.

in vec2 place;
flat in vec4 body;
flat in vec4 edge;
flat in vec3 measure;

uniform float opacity;

out vec4 color;

float cover(float off) {
    return clamp(0.5 - off, 0.0, 1.0);
}

void main() {
    float radius = measure.x, width = measure.y;
    vec2 p = abs(place);
    float off;
    if (measure.z < 0.5) off = length(p) - radius;
    else if (measure.z < 1.5) off = max(p.x, p.y) - radius;
    else if (measure.z < 2.5) off = (p.x + p.y - radius) * 0.7071;
    else if (measure.z < 3.5) off = abs(length(p) - radius + 0.5 * width) - 0.5 * width;
    else off = length(p - min(0.5 * (p.x + p.y), radius)) - 0.5 * width;
    bool has_body = measure.z < 2.5;
    float inside = has_body ? cover(off + width) : 0.0;
    vec4 mixed = mix(vec4(edge.rgb, 1.0) * edge.a, vec4(body.rgb, 1.0) * body.a, inside);
    color = mixed * (cover(off) * opacity);
    if (color.a < 0.02) discard;
}
