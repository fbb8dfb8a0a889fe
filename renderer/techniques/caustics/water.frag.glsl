// What the water's surface shows: the scene below it, which each ray looks for in a picture of it from where the rays of flat
// water seem to come from, and the background.
layout(location = 0) in vec3 relative_position;
layout(location = 1) in vec3 water_normal;

layout(binding = 0) uniform sampler2D map_depth;  // eye-space z over map_far of the scene in the water; 0: nothing
layout(binding = 1) uniform sampler2D map_color;

uniform mat4 map_from_relative;
uniform vec3 map_camera;  // relative to the camera
uniform vec3 map_forward;
uniform float map_far;
uniform float reach;        // beyond which there is nothing
uniform float texel_slope;  // by how much surfaces that are steep to the map differ between texels, over their depth
uniform float ior;
uniform vec3 absorption;
uniform vec3 background;

layout(location = 0) out vec4 color;
layout(location = 1) out vec4 seen;

const int kSteps = 64;
const int kBisections = 14;

vec2 map_place(vec3 p) {
  vec4 clip = map_from_relative * vec4(p, 1.0);
  return 0.5 + 0.5 * clip.xy / clip.w;
}

// By how much p is behind what the map shows where it is; negative where it shows nothing.
float behind(vec3 p) {
  vec2 place = map_place(p);
  ivec2 size = textureSize(map_depth, 0);
  ivec2 texel = ivec2(floor(place * vec2(size)));
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size))) return -reach;
  float shown = texelFetch(map_depth, texel, 0).r * map_far;
  return shown > 0.0 ? dot(p - map_camera, map_forward) - shown : -reach;
}

// The way along a ray to what it meets; -1: nothing. Where it passes behind something that hides what it meets, the place
// where it does so.
float meeting(vec3 start, vec3 ray) {
  float step = reach / float(kSteps);
  float before = 0.0;
  float behind_start = behind(start);
  bool over = behind_start <= 0.0;
  // At a wall that the water touches a ray may begin a little behind it: what it meets if it meets nothing else.
  bool begins_there = !over && behind_start < texel_slope * dot(start - map_camera, map_forward);
  float hidden = begins_there ? 0.0 : -1.0;
  bool passed_behind = false;
  for (int i = 1; i <= kSteps; ++i) {
    float after = float(i) * step;
    bool under = behind(start + after * ray) > 0.0;
    if (over && under) {
      float near = before;
      float far = after;
      for (int j = 0; j < kBisections; ++j) {
        float middle = 0.5 * (near + far);
        if (behind(start + middle * ray) > 0.0)
          far = middle;
        else
          near = middle;
      }
      // On a surface the two ends are one place; at an edge they are not.
      vec3 met = start + far * ray;
      if (behind(met) < 4.0 * (far - near) + texel_slope * dot(met - map_camera, map_forward)) return far;
      if (!passed_behind) hidden = far;
      passed_behind = true;
    }
    over = !under;
    before = after;
  }
  return hidden;
}

void main() {
  vec3 view = normalize(relative_position);
  vec3 normal = normalize(water_normal);
  bool from_above = dot(view, normal) < 0.0;
  if (!from_above) normal = -normal;
  float ratio = from_above ? 1.0 / ior : ior;
  float cos_in = -dot(view, normal);
  float cos_out_squared = 1.0 - ratio * ratio * (1.0 - cos_in * cos_in);
  float passes = 0.0;
  if (cos_out_squared > 0.0) {
    float cos_out = sqrt(cos_out_squared);
    float across = (ratio * cos_in - cos_out) / (ratio * cos_in + cos_out);
    float along = (cos_in - ratio * cos_out) / (cos_in + ratio * cos_out);
    passes = 1.0 - 0.5 * (across * across + along * along);
  }
  vec3 into_water = from_above ? refract(view, normal, ratio) : reflect(view, normal);
  float way = meeting(relative_position, into_water);
  vec3 below = background;
  seen = vec4(0.0);
  if (way >= 0.0) {
    vec3 met = relative_position + way * into_water;
    below = texture(map_color, map_place(met)).rgb;
    seen = vec4(met, 1.0);
  }
  below *= exp(-absorption * max(way, 0.0));
  float share = from_above ? passes : 1.0 - passes;
  color = vec4(mix(background, below, share), 1.0);
}
