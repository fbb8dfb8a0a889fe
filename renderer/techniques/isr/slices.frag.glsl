// Gathers indirect light with visibility (renderer/techniques/isr_slices.h): half-planes through the camera and the
// receiver are searched from the receiver's direction outwards, and what is found covers sectors of directions.
//
// In such a half-plane a direction from the receiver is an angle A from the way to the camera, and a direction from the
// camera an angle T from the way to the receiver. Along a ray from the receiver T only grows: what has a smaller T
// hides what has a larger one.
#include "shaders/frame.glsl"
#include "shaders/tiles.glsl"
#include "techniques/isr/dither.glsl"
#include "techniques/isr/samples_share.glsl"
#include "techniques/isr/surfel.glsl"

layout(binding = 8) uniform sampler2D coarse_normals;  // shading normals of the patches, octahedral
layout(binding = 9) uniform sampler2D surfels;
layout(binding = 10) uniform sampler2D radiance;  // of the sides towards the camera, and above them the other sides

uniform int slices;  // planes; each has two sides
uniform int steps;   // on each side
#ifdef SAMPLES_BY_DEPTH
uniform float depth_exponent;
uniform float depth_scale;  // makes the mean of the steps what it would be
#endif
uniform float step_exponent;
uniform float thickness;  // of what is found, as a share of its distance from the camera
uniform vec3 background;

// Of a white surface; alpha: the share of directions in which something was seen. SURFEL_RECEIVERS: both sides as in
// `radiance`; alpha: what the light is worth.
layout(location = 0) out vec4 indirect;
#ifdef OCCLUSION
uniform float occlusion_reach;      // at distance 1 along the camera's axis
layout(location = 1) out vec2 cover;  // openness; the share of directions that surfaces cover
#endif

const float kPi = 3.14159265;
const uint kSectors = 32u;
// Surfaces whose plane passes the receiver at less than this share of their distance are taken for its own.
const float kOwnPlane = 0.01;
const float kRounding = 1e-5;  // of the distance from the camera

// The sectors of one side of a slice have equal shares of the cosine-weighted light: the integral of
// sin A cos(A - g) over A, where g is the angle of the normal's projection into the plane.
struct Sectors {
  float first, last;      // angles that see the receiver's hemisphere
  float cos_g, sin_g;
  float cos_first, cos_last;
  float start, total;     // the integral up to `first`, and from there to `last`
};

float integral_to(Sectors s, float angle, float cosine, float sine) {
  float cos_2a = 2.0 * cosine * cosine - 1.0;
  float sin_2a = 2.0 * cosine * sine;
  return 0.25 * (s.cos_g + 2.0 * angle * s.sin_g - cos_2a * s.cos_g - sin_2a * s.sin_g);
}

// The arc cosine, off by less than 7e-5 (Abramowitz and Stegun 4.4.45).
float arc_cosine(float x) {
  float a = abs(x);
  float r = sqrt(max(1.0 - a, 0.0)) * (1.5707288 + a * (-0.2121144 + a * (0.0742610 - 0.0187293 * a)));
  return x < 0.0 ? kPi - r : r;
}

Sectors make_sectors(float cos_g, float sin_g) {
  Sectors s;
  s.cos_g = cos_g;
  s.sin_g = sin_g;
  float g = sin_g >= 0.0 ? arc_cosine(cos_g) : -arc_cosine(cos_g);
  s.first = clamp(g - 0.5 * kPi, 0.0, kPi);
  s.last = clamp(g + 0.5 * kPi, 0.0, kPi);
  s.cos_first = cos(s.first);
  s.cos_last = cos(s.last);
  s.start = integral_to(s, s.first, s.cos_first, sin(s.first));
  s.total = integral_to(s, s.last, s.cos_last, sin(s.last)) - s.start;
  return s;
}

// Where a direction lies among the sectors, 0..1. `cosine` and `sine` are those of its angle A, 0..pi.
float place_of(Sectors s, float cosine, float sine) {
  if (cosine >= s.cos_first) return 0.0;
  if (cosine <= s.cos_last) return 1.0;
  return clamp((integral_to(s, arc_cosine(cosine), cosine, sine) - s.start) / s.total, 0.0, 1.0);
}

uint sector_mask(float a, float b, float dither) {
  uint low = min(uint(min(a, b) * float(kSectors) + dither), kSectors);
  uint high = min(uint(max(a, b) * float(kSectors) + dither), kSectors);
  uint count = high - low;
  if (count == 0u) return 0u;
  return (count == kSectors ? ~0u : (1u << count) - 1u) << low;
}

// Sine of half a turn's share, 0..1 (Taylor's series; off by less than 4e-6, and by no larger a share near 0).
float quarter_sine(float u) {
  float u2 = u * u;
  return u * (1.57079633 + u2 * (-0.64596410 + u2 * (0.07969263 + u2 * (-0.00468175 + u2 * 0.00016044))));
}

// Cosine and sine of the angle T that a share of the steps, 0..1, reaches.
vec2 search_angle(float share) {
#ifdef STEPS_SQUARED
  float u = share * share;
#else
  float u = pow(share, step_exponent);
#endif
  float s = quarter_sine(u);  // of T / 2
  return vec2(1.0 - 2.0 * s * s, 2.0 * s * quarter_sine(1.0 - u));
}

const int kJoinedLayers = 4;

// The last piece of a layer.
struct Piece {
  vec4 surfel;  // all 0: there is none
  float place;  // where it ends
};
const Piece kNoPiece = Piece(vec4(0.0), 0.0);
const float kSameDistance = 1e-3;  // as a share: what is nearer than that is no layer of its own either

// Whether the planes of a piece and of the next one meet no farther from the border between their steps than an angle, whose
// tangent is `reach`. `along` is across the border's ray, in the half-plane.
bool meet(vec4 piece, vec4 next, vec3 border, vec3 along, float reach) {
  if (!is_surface(piece)) return false;
  vec3 nearer = next.w * piece.xyz - piece.w * next.xyz;  // times a ray: above 0 where the piece's plane is the nearer one
  return abs(dot(nearer, border)) <= reach * abs(dot(nearer, along)) + kSameDistance * abs(piece.w * dot(next.xyz, border));
}

struct Receiver {
  float distance_;  // from the camera
  vec3 outward;     // the way from the camera, unit
  vec3 side;        // a unit vector across it, and the other one
  vec3 other;
#ifdef OCCLUSION
  float occluders;  // how far those are that block
#endif
};

Receiver receiver_at(vec3 position) {
  Receiver r;
  r.distance_ = length(position);
  r.outward = position / r.distance_;
  r.side = normalize(abs(r.outward.y) < 0.9 ? cross(r.outward, vec3(0.0, 1.0, 0.0)) : cross(r.outward, vec3(1.0, 0.0, 0.0)));
  r.other = cross(r.outward, r.side);
  return r;
}

struct Found {
  vec4 light;  // alpha: what of all directions saw something
  vec2 cover;  // what near surfaces block, and what surfaces cover
};

// One side of a slice: what its sectors see, times their part of the light.
Found search(Receiver r, int steps, vec3 across, Sectors sectors, float jitter, float dither) {
  uint covered = 0u;
  vec3 seen = vec3(0.0);
  uint known = 0u;
  vec2 cover = vec2(0.0);
  int rows = int(eye_up.w);  // of a layer
  int layers = int(eye_forward.w);
  int all_rows = rows * layers;
  float step_share = 1.0 / float(steps);
  vec2 before = vec2(1.0, 0.0);  // cosine and sine of T where the step begins
  vec3 ray_before = r.outward;
  float reach_before = 0.0;  // from the middle of the step before to its end
  Piece last[kJoinedLayers];  // of the step before
  for (int layer = 0; layer < kJoinedLayers; ++layer) last[layer] = kNoPiece;
  for (int i = 0; i <= steps; ++i) {
    float share = min((float(i) + jitter) * step_share, 1.0);
    vec2 after = search_angle(share);
    vec2 middle = search_angle(max(share - 0.5 * step_share, 0.5 * share));
    vec3 ray_middle = middle.x * r.outward + middle.y * across;
    ivec2 texel = tile_texel(ray_middle);
    if (texel.x < 0) break;
    vec3 ray_after = after.x * r.outward + after.y * across;
    // An edge between what two steps find lies between their middles, give or take a texel.
    vec3 along = before.x * across - before.y * r.outward;
    float reach = max(length(ray_middle - ray_before), reach_before) + texel_width(texel);
    vec2 nearer = vec2(0.0);  // how far the layer before reaches at the step's two borders
    for (int layer = 0; layer < layers; ++layer) {
      vec4 surfel = texelFetch(surfels, texel, 0);
      if (!is_surface(surfel)) {
        for (int other = layer; other < kJoinedLayers; ++other) last[other] = kNoPiece;
#ifndef ALL_FACES
        if (layer > 0) break;
#endif
        // Infinitely far: A and T add up to pi. So it is behind the last surface, where all were kept.
        uint fresh = sector_mask(place_of(sectors, -before.x, before.y), place_of(sectors, -after.x, after.y), dither) & ~covered;
        covered |= fresh;
        uint count = uint(bitCount(fresh));
        known += count;
        seen += float(count) * background;
        break;
      }
      float z = length(surfel.xyz);
      float height = dot(surfel.xyz, r.outward) * r.distance_ - surfel.w;  // of the receiver over the plane, times z
      float t0 = clamp(surfel.w / min(dot(surfel.xyz, ray_before), -1e-5 * z), 0.5 * z, 2.0 * z);
      float t1 = clamp(surfel.w / min(dot(surfel.xyz, ray_after), -1e-5 * z), 0.5 * z, 2.0 * z);
      // Planes that cross within the step do not go on through each other: a floor behind a wall ends at the wall.
      t0 = max(t0, nearer.x);
      t1 = max(t1, nearer.y);
      nearer = vec2(t0, t1);
      // Along the way to the camera, and across it.
      vec2 end0 = vec2(r.distance_ - t0 * before.x, t0 * before.y);
      vec2 end1 = vec2(r.distance_ - t1 * after.x, t1 * after.y);
      float length1 = length(end1);
      if (abs(height) > (kOwnPlane * length1 + kRounding * r.distance_) * z) {
        vec2 d0 = end0 / max(length(end0), 1e-20);
        vec2 d1 = end1 / max(length1, 1e-20);
        // Surfaces that meet where one step follows the other leave no gap between their pieces.
        bool joined = layer < kJoinedLayers && meet(last[layer].surfel, surfel, ray_before, along, reach);
        float place0 = joined ? last[layer].place : place_of(sectors, d0.x, d0.y);
        float place1 = place_of(sectors, d1.x, d1.y);
        if (layer < kJoinedLayers) last[layer] = Piece(surfel, place1);
        uint fresh = sector_mask(place0, place1, dither) & ~covered;
        if (fresh != 0u) {
          covered |= fresh;
          uint count = uint(bitCount(fresh));
          known += count;
#ifdef OCCLUSION
          float nearness = max(1.0 - length1 * length1 / (r.occluders * r.occluders), 0.0);
          cover += float(count) * vec2(nearness, 1.0);
#endif
          int row = height > 0.0 ? texel.y : texel.y + all_rows;
          seen += float(count) * texelFetch(radiance, ivec2(texel.x, row), 0).rgb;
        }
#ifdef THICKNESS
        // What lies behind it is hidden as far as it is thick; what it looks like there is not known.
        vec2 deep0 = vec2(r.distance_ - (1.0 + thickness) * t0 * before.x, (1.0 + thickness) * t0 * before.y);
        vec2 deep1 = vec2(r.distance_ - (1.0 + thickness) * t1 * after.x, (1.0 + thickness) * t1 * after.y);
        deep0 /= max(length(deep0), 1e-20);
        deep1 /= max(length(deep1), 1e-20);
        float place2 = place_of(sectors, deep0.x, deep0.y);
        float place3 = place_of(sectors, deep1.x, deep1.y);
        covered |= sector_mask(min(min(place0, place1), min(place2, place3)), max(max(place0, place1), max(place2, place3)), dither);
#endif
      } else if (layer < kJoinedLayers) {
        last[layer] = Piece(surfel, 1.0);  // the receiver's own plane is its horizon
      }
      texel.y += rows;
    }
    if (covered == ~0u) break;
    before = after;
    reach_before = length(ray_after - ray_middle);
    ray_before = ray_after;
  }
  float part = sectors.total / float(kSectors);
  return Found(part * vec4(seen, float(known)), part * cover);
}

// What a surface at the receiver sees that faces `normal`: light of a white one, and shares of all directions.
Found gather(Receiver r, int steps, vec3 normal, float turn, float jitter, float dither) {
  Found sum = Found(vec4(0.0), vec2(0.0));
  float weights = 0.0;
  for (int i = 0; i < slices; ++i) {
    float angle = (float(i) + turn) * kPi / float(slices);
    vec3 across = cos(angle) * r.side + sin(angle) * r.other;
    vec2 projected = vec2(-dot(normal, r.outward), dot(normal, across));
    float size = length(projected);
    if (size < 1e-4) continue;
    projected /= size;
    for (int side = 0; side < 2; ++side) {
      Sectors sectors = make_sectors(projected.x, projected.y);
      if (sectors.total > 1e-6) {
        float offset = fract(jitter + 0.5 * float(side) + 0.38196601 * float(i));
        Found found = search(r, steps, across, sectors, offset, dither);
        sum.light += size * found.light;
        sum.cover += size * found.cover;
        weights += size * sectors.total;
      }
      across = -across;
      projected.y = -projected.y;
    }
  }
  float scale = weights > 0.0 ? 1.0 / weights : 0.0;
  return Found(scale * sum.light, scale * sum.cover);
}

float unit(uint bits) { return (float(bits >> 8) + 0.5) / 16777216.0; }

#ifdef SURFEL_RECEIVERS
// Light is worth little where next to nothing was seen.
vec4 filled(vec4 gathered) {
#ifdef UNKNOWN_AMBIENT
  const float kEnoughKnown = 0.1;
  return vec4(gathered.rgb / max(gathered.a, 1e-3), min(gathered.a / kEnoughKnown, 1.0));
#else
  return vec4(gathered.rgb, 1.0);
#endif
}

void main() {
  indirect = vec4(0.0);
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int rows = textureSize(coarse_patches, 0).y;
  bool back = pixel.y >= rows;
  if (back) pixel.y -= rows;
  vec4 receiver = texelFetch(coarse_patches, pixel, 0);
  if (receiver.w == kNoPatch) return;
  vec3 normal = unpack_normal(receiver.w);
  uint h = pixel_hash(pixel);
  float turn = unit(h), jitter = unit(h * 0x9e3779b9u), dither = unit(h * 0x85ebca6bu);
  indirect = filled(gather(receiver_at(receiver.xyz), steps, back ? -normal : normal, turn, jitter, dither).light);
}
#else
void main() {
  indirect = vec4(0.0);
#ifdef OCCLUSION
  cover = vec2(1.0, 0.0);
#endif
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 patch_ = texelFetch(coarse_patches, pixel, 0);
  if (patch_.w == kNoPatch) return;
  vec3 normal = decode_octahedral(texelFetch(coarse_normals, pixel, 0).xy);
  mat3 eye = transpose(mat3(eye_right.xyz, eye_up.xyz, eye_forward.xyz));
  Receiver r = receiver_at(eye * patch_.xyz);
  float n = float(tiled_order(pixel)) + 0.5;
  int steps_here = steps;
#ifdef SAMPLES_BY_DEPTH
  steps_here = int(ceil(float(steps) * samples_share(r.distance_, depth_exponent, depth_scale)));
#endif
#ifdef OCCLUSION
  r.occluders = occlusion_reach * eye_z(patch_.xyz);
#endif
  Found found = gather(r, steps_here, eye * normal, n / 64.0, fract(n * 0.61803399), fract(n * 0.75487767));
  indirect = found.light;
#ifdef OCCLUSION
  cover = vec2(1.0 - found.cover.x, found.cover.y);
#endif
}
#endif
