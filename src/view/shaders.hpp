#pragma once
// The programs of the graphics card. Every vertex carries one depth, that of its distance from the
// eye; a ball's is the length of the tangent from the eye, the same all over its disc: whatever
// does not overlap the ball is in front of it or behind it as that says.

namespace clack::view::shaders {

constexpr char const* common = R"(#version 330 core
uniform mat4 projection;
uniform vec3 eye, background;
uniform float radius, nearest, farthest;
float depth_of(float distance) { return (distance - nearest) / (farthest - nearest); }
vec4 at_depth(vec4 place, float depth) {
    return vec4(place.xy, (2 * depth - 1) * place.w, place.w);
}
)";

/// A ball is a disc that faces the eye, as large as the cone of rays that touch the ball.
constexpr char const* ball_vertex = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour; // the last is the glow
out vec2 on_disc;
flat out vec4 tint;
flat out float fog;
uniform vec3 up;
void main() {
    vec3 sight = eye - place;
    float distance = length(sight);
    float tangent = sqrt(max(dot(sight, sight) - radius * radius, 1e-12));
    vec3 w = sight / distance, u = normalize(cross(up, w)), v = cross(w, u);
    on_disc = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2 - 1;
    vec3 corner = place + radius * distance / tangent * (on_disc.x * u + on_disc.y * v);
    float depth = depth_of(tangent);
    tint = colour;
    fog = clamp(depth, 0, 1);
    gl_Position = at_depth(projection * vec4(corner, 1), depth);
}
)";

/// The same ball as a dot, for balls of a few pixels.
constexpr char const* dot_vertex = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
flat out vec4 tint;
flat out float fog;
uniform float pixels; // across for an object of length 1 at distance 1
void main() {
    float distance = length(eye - place);
    float depth = depth_of(sqrt(max(distance * distance - radius * radius, 1e-12)));
    tint = colour;
    fog = clamp(depth, 0, 1);
    gl_Position = at_depth(projection * vec4(place, 1), depth);
    gl_PointSize = max(2 * radius * pixels / gl_Position.w, 1);
}
)";

constexpr char const* lighting = R"(
flat in vec4 tint;
flat in float fog;
out vec4 seen;
vec3 lit(vec3 normal) { // the light stands above and to the left of the eye
    const vec3 light = vec3(-0.43, 0.60, 0.675), half_way = vec3(-0.235, 0.328, 0.915);
    float direct = max(dot(normal, light), 0);
    float sky = 0.5 + 0.5 * normal.y;
    vec3 base = tint.rgb * tint.rgb; // about linear
    vec3 shade = base * (0.16 + 0.20 * sky + 0.80 * direct) * (0.50 + 0.50 * normal.z);
    float gleam = max(dot(normal, half_way), 0);
    gleam *= gleam; gleam *= gleam; gleam *= gleam; gleam *= gleam; gleam *= gleam;
    // A flash is white in the middle and leaves the rim its colour, which goes on to tell something.
    return mix(shade + vec3(0.30 * gleam), vec3(1), tint.a * tint.a * normal.z * normal.z);
}
vec4 finished(vec3 linear) { return vec4(mix(sqrt(linear), background, 0.55 * fog), 1); }
)";

constexpr char const* ball_fragment = R"(
in vec2 on_disc;
void main() {
    float square = dot(on_disc, on_disc);
    if (square > 1) discard;
    seen = finished(lit(vec3(on_disc, sqrt(1 - square))));
}
)";

constexpr char const* dot_fragment = R"(
void main() {
    vec2 on_disc = vec2(2, -2) * gl_PointCoord + vec2(-1, 1);
    float square = dot(on_disc, on_disc);
    if (square > 1.2) discard; // a dot of one pixel has its centre within
    seen = finished(lit(vec3(on_disc, sqrt(max(1 - square, 0)))));
}
)";

/// A line is a strip as wide as asked for, in pixels.
constexpr char const* line_vertex = R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
layout(location = 3) in float width;
uniform vec2 size; // of the picture [pixels]
flat out vec4 tint;
out float fog;
void main() {
    vec4 a = projection * vec4(from, 1), b = projection * vec4(to, 1);
    vec2 along = (b.xy / b.w - a.xy / a.w) * size;
    float length_seen = max(length(along), 1e-6);
    vec2 across = vec2(-along.y, along.x) / length_seen * width / size;
    bool first = (gl_VertexID & 1) == 0;
    vec4 place = first ? a : b;
    place.xy += across * place.w * (gl_VertexID < 2 ? 1 : -1);
    float depth = depth_of(distance(eye, first ? from : to));
    tint = colour;
    fog = clamp(depth, 0, 1);
    gl_Position = at_depth(place, depth);
}
)";

constexpr char const* line_fragment = R"(
flat in vec4 tint;
in float fog;
out vec4 seen;
void main() { seen = vec4(mix(tint.rgb, background, 0.55 * fog * tint.a), 1); }
)";

} // namespace clack::view::shaders
