/// The shaders, in parts that are joined after the prologue of gl.h and compiled. All positions are relative to the eye, in metres. All
/// light is linear until `shown` converts it.
#pragma once

namespace pushback::shaders {

/// Computes the position and the normal of a vertex of an instance (mesh.h). For marks, `pull` moves it towards the eye by that many
/// radii, in depth only.
inline constexpr const char* instance_vertex = R"(
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 place;  // position, radius
layout(location = 3) in vec4 turn;   // quaternion
layout(location = 4) in vec3 half_extents;
layout(location = 5) in vec3 colour;
uniform mat4 clip_from_eye;
uniform float pull;
out vec3 at_place, at_normal, at_colour;

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

void main() {
  at_place = place.xyz + rotate(turn, corner * half_extents + normal * place.w);
  at_normal = rotate(turn, normal);
  at_colour = colour;
  gl_Position = clip_from_eye * vec4(at_place, 1);
  if (pull > 0.0) {
    vec4 pulled = clip_from_eye * vec4(at_place * max(0.1, 1.0 - pull * place.w / length(at_place)), 1);
    gl_Position.z = pulled.z / pulled.w * gl_Position.w;
  }
}
)";

inline constexpr const char* plane_vertex = R"(
uniform mat4 clip_from_eye;
uniform vec3 centre, across, along;
uniform vec2 half_size;
out vec3 at_place;
out vec2 on_plane;  // m, from the centre

void main() {
  vec2 side = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
  on_plane = side * half_size;
  at_place = centre + on_plane.x * across + on_plane.y * along;
  gl_Position = clip_from_eye * vec4(at_place, 1);
}
)";

inline constexpr const char* background_vertex = R"(
void main() {  // one triangle over the whole picture
  gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 1, 1);
}
)";

inline constexpr const char* depth_fragment = "void main() {}\n";

/// The part that all fragment shaders with colour share: the background, and the tone map.
inline constexpr const char* common_fragment = R"(
uniform vec2 picture_corner, picture_size;  // pixels of the framebuffer
layout(location = 0) out vec4 pixel;

vec3 background() {
  float height = (gl_FragCoord.y - picture_corner.y) / picture_size.y;
  return mix(vec3(0.795, 0.82, 0.855), vec3(0.74, 0.775, 0.83), smoothstep(0.45, 1.0, height));
}

// The neutral tone map of the Khronos group: colours are kept up to 0.8, then the brightest lose their saturation.
vec3 tone(vec3 light) {
  float least = min(light.r, min(light.g, light.b));
  light -= least < 0.08 ? least - 6.25 * least * least : 0.04;
  float peak = max(light.r, max(light.g, light.b));
  const float knee = 0.8 - 0.04;
  if (peak <= knee) return light;
  float pressed = 1.0 - (1.0 - knee) * (1.0 - knee) / (peak + 1.0 - 2.0 * knee);
  float grey = 1.0 - 1.0 / (0.15 * (peak - pressed) + 1.0);
  return mix(light * pressed / peak, vec3(pressed), grey);
}
)";

/// The key light with its shadow, and the sky with a shadow for each of its few directions.
inline constexpr const char* light_fragment = R"(
const int sky_count = 4;
uniform sampler2DShadow key_map;
uniform mat4 key_from_eye;
uniform vec3 key_size, key_direction;
uniform float key_texel, key_blur;  // m
uniform sampler2DArrayShadow sky_map;
uniform mat4 sky_from_eye[sky_count];
uniform vec3 sky_size[sky_count], sky_direction[sky_count];
uniform float sky_texel, sky_blur;  // m

// Where a filter looks: spread evenly over a disc of radius 1, like the seeds of a sunflower. The compiler unrolls the
// loops that use it, so that all this is worked out before anything is drawn.
vec2 seed(int i, int count) {
  if (count == 1) return vec2(0);
  return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(2.3999632 * float(i)), sin(2.3999632 * float(i)));
}

// A surface that leans away from the light is deeper on one side: m per m across the map. Knowing this, a wide filter
// does not take the surface for its own shadow.
vec2 slope(mat4 map, vec3 size, vec3 normal) {
  vec3 lean = size * (mat3(map) * normal);
  return clamp(lean.xy / max(-lean.z, 0.05), -5.0, 5.0);
}

float key_visible(vec3 place, vec3 normal) {
  vec3 at = (key_from_eye * vec4(place + key_texel * normal, 1)).xyz;
  if (any(greaterThan(abs(at.xy - 0.5), vec2(0.5)))) return 1.0;
  vec2 lean = slope(key_from_eye, key_size, normal);
  at.z -= key_texel / key_size.z;
  float seen = 0.0;
  for (int i = 0; i < KEY_TAPS; ++i) {
    vec2 aside = key_blur * seed(i, KEY_TAPS);
    vec3 tap = at + vec3(aside, dot(lean, aside)) / key_size;
    seen += texture(key_map, vec3(tap.xy, min(tap.z, 1.0)));  // beyond the map nothing casts shadows
  }
  return seen / float(KEY_TAPS);
}

float sky_visible(vec3 place, vec3 normal) {
  float seen = 0.02, total = 0.02;
  for (int k = 0; k < sky_count; ++k) {
    float facing = max(dot(normal, sky_direction[k]), 0.0);
    vec3 at = (sky_from_eye[k] * vec4(place + sky_texel * normal, 1)).xyz;
    float open = 1.0;
    if (facing > 0.0 && all(lessThan(abs(at.xy - 0.5), vec2(0.5)))) {
      vec2 lean = slope(sky_from_eye[k], sky_size[k], normal);
      at.z -= sky_texel / sky_size[k].z;
      open = 0.0;
      for (int i = 0; i < SKY_TAPS; ++i) {
        vec2 aside = sky_blur * seed(i, SKY_TAPS);
        vec3 tap = at + vec3(aside, dot(lean, aside)) / sky_size[k];
        open += texture(sky_map, vec4(tap.xy, float(k), min(tap.z, 1.0))) / float(SKY_TAPS);
      }
    }
    seen += facing * open;
    total += facing;
  }
  return seen / total;
}

const vec3 key_colour = vec3(1.0, 0.965, 0.90);
const vec3 sky_colour = vec3(0.88, 0.95, 1.08);
const vec3 ground_colour = vec3(1.02, 1.0, 0.96);

// What falls on a surface, times 1/pi.
vec3 irradiance(vec3 normal, float key, float sky) {
  float upward = 0.5 + 0.5 * normal.y;
  vec3 around = mix(0.28 * ground_colour * mix(0.55, 1.0, sky), 0.44 * sky_colour * sky, upward);
  return 0.90 * key * max(dot(normal, key_direction), 0.0) * key_colour + around;
}
)";

inline constexpr const char* solid_fragment = R"(
in vec3 at_place, at_normal, at_colour;

// The highlight of a rough surface (GGX, Smith, Schlick), for a light from direction l.
float highlight(vec3 n, vec3 v, vec3 l, float roughness) {
  vec3 h = normalize(v + l);
  float nl = max(dot(n, l), 0.0), nv = max(dot(n, v), 1e-3), nh = max(dot(n, h), 0.0), vh = max(dot(v, h), 0.0);
  float a = roughness * roughness, a2 = a * a;
  float d = nh * nh * (a2 - 1.0) + 1.0;
  float spread = a2 / (d * d);
  float hiding = 0.5 / max(nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2), 1e-4);
  float mirror = 0.04 + 0.96 * pow(max(1.0 - vh, 0.0), 5.0);
  return spread * hiding * mirror * nl / 3.14159;
}

void main() {
  vec3 n = normalize(at_normal), v = -normalize(at_place);
  float key = dot(n, key_direction) > 0.0 ? key_visible(at_place, n) : 0.0;
  float sky = sky_visible(at_place, n);
  vec3 light = at_colour * irradiance(n, key, sky);
  light += 0.10 * at_colour * max(dot(n, v), 0.0);  // a little from the viewer, so that no side is black
  light += 2.2 * key * highlight(n, v, key_direction, 0.38) * key_colour;
  float rim = pow(clamp(1.0 - dot(n, v), 0.0, 1.0), 5.0);
  light += 0.04 * mix(0.5, 1.0, sky);  // what the surroundings mirror in it; the tone map takes as much away again
  light += 0.16 * rim * sky * (0.4 + 0.6 * max(n.y, 0.0)) * sky_colour;
  pixel = vec4(shown(tone(light)), 1);
}
)";

/// Arrows and dots. They are lit evenly and without shadows, because their colour has a meaning. A contrasting rim sets dots off.
inline constexpr const char* mark_fragment = R"(
uniform float opacity, outline;
in vec3 at_place, at_normal, at_colour;

void main() {
  vec3 n = normalize(at_normal), v = -normalize(at_place);
  float light = 0.72 + 0.28 * max(dot(n, normalize(vec3(0.2, 1.0, 0.0) + v)), 0.0);
  vec3 rim = dot(at_colour, vec3(0.3, 0.6, 0.1)) < 0.04 ? vec3(0.75) : vec3(0.012);  // whichever stands out
  float edge = outline * (1.0 - smoothstep(0.42, 0.62, dot(n, v)));
  pixel = vec4(shown(mix(at_colour * light, rim, edge)), opacity);
}
)";

inline constexpr const char* plane_fragment = R"(
uniform vec3 normal;
uniform vec2 phase;
uniform float fade, coarse, fine;  // fine, coarse: how much is seen of cells of 0.1 m and of 10 m
in vec3 at_place;
in vec2 on_plane;

// A wave of period 2 that is 1, then -1, averaged over a pixel of this width.
vec2 rise(vec2 x) { return 1.0 - abs(mod(x, 2.0) - 1.0); }
vec2 averaged(vec2 x, vec2 width) { return (rise(x + 0.5 * width) - rise(x - 0.5 * width)) / width; }
float checker(vec2 x, vec2 width) {
  vec2 stripes = averaged(x, width);
  return stripes.x * stripes.y;
}

void main() {
  vec2 x = on_plane + phase;
  vec2 width = max(abs(dFdx(on_plane)) + abs(dFdy(on_plane)), 1e-6);
  float level = (1.0 - 0.75 * coarse) * checker(x, width) + 0.7 * fine * checker(10.0 * x, 10.0 * width) + 0.8 * coarse * checker(0.1 * x, 0.1 * width);
  vec3 albedo = vec3(0.735, 0.75, 0.77) * (1.0 + 0.042 * level);
  float key = key_visible(at_place, normal);
  vec3 light = tone(albedo * irradiance(normal, key, sky_visible(at_place, normal)));
  if (fade > 0.0) {
    float far = length(at_place) / fade;
    light = mix(background(), light, exp(-3.0 * far * far));
  }
  pixel = vec4(shown(light), 1);
}
)";

inline constexpr const char* background_fragment = "void main() { pixel = vec4(shown(background()), 1); }\n";

}  // namespace pushback::shaders
