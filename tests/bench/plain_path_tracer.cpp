#include "tests/bench/plain_path_tracer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "renderer/paths/path_draw.h"
#include "scene/light_points.h"

namespace lightbench::bench {
namespace {

constexpr float kEnd = 1 - 1e-4f;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Hit {
  glm::vec3 position, normal, offset, albedo, direction;
  float distance, facing;
  const PathMaterial* material;
};

glm::vec3 cosine_direction(float u, float v, const glm::vec3& n) {
  const float a = 2 * u - 1, b = 2 * v - 1;
  const bool wide = std::abs(a) > std::abs(b);
  const float radius = wide ? a : b;
  const float angle = radius == 0 ? 0 : std::numbers::pi_v<float> / 4 * (wide ? b / a : 2 - a / b);
  const float x = radius * std::cos(angle), y = radius * std::sin(angle);
  const float z = std::sqrt(std::max(1 - radius * radius, 1e-12f));
  const float sign = n.z < 0 ? -1.0f : 1.0f, p = -1 / (sign + n.z), q = n.x * n.y * p;
  const glm::vec3 tangent(1 + sign * n.x * n.x * p, sign * q, -sign * n.x);
  const glm::vec3 bitangent(q, sign + n.y * n.y * p, -n.y);
  return x * tangent + y * bitangent + z * n;
}

class PlainTracer {
 public:
  PlainTracer(const Scene& scene, const View& view, int width, int height, const PathTracerOptions& options)
      : scene_(scene),
        camera_(view.camera, width, height),
        options_(options),
        lights_(light_points(scene)),
        background_(scene.background.color) {}

  glm::vec3 pixel(int x, int y) const {
    const auto hit = intersect(camera_.position(), camera_.direction(x, y));
    if (!hit) return background_;
    glm::vec3 sum(0);
    const int samples = options_.samples / 2;
    const std::uint32_t primary = primary_seed(picture_seed(options_.seed), x, y);
    for (int half = 0; half < 2; ++half)
      for (int i = 0; i < samples; ++i) sum += path(*hit, half_seed(primary, half), std::uint32_t(i));
    return hit->material->emission + lit(*hit, hit->material->specular) + sum / float(2 * samples);
  }

 private:
  std::optional<Hit> intersect(const glm::vec3& origin, const glm::vec3& direction) const {
    RTCRayHit query;
    std::memset(&query, 0, sizeof query);
    set(query.ray, origin, direction, kInfinity);
    query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.embree.top(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const SurfacePoint p =
        scene_.surfaces.point(query.hit.instID[0], query.hit.geomID, query.hit.primID, query.hit.u,
                              query.hit.v, {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z});
    Hit hit{origin + query.ray.tfar * direction,
            glm::normalize(p.normal),
            {},
            p.albedo,
            direction,
            query.ray.tfar,
            0,
            p.material};
    glm::vec3 face = glm::normalize(p.face);
    if (glm::dot(face, direction) > 0) face = -face;
    if (glm::dot(hit.normal, direction) > 0) hit.normal = -hit.normal;
    hit.facing = -glm::dot(face, direction);
    const glm::vec3 most = glm::max(glm::abs(origin), glm::abs(hit.position));
    hit.offset = face * (std::max({most.x, most.y, most.z}) * 32 * std::numeric_limits<float>::epsilon());
    return hit;
  }

  bool occluded(const Hit& hit, const glm::vec3& to, bool directional) const {
    const glm::vec3 way = directional ? to : to - hit.position;
    const glm::vec3 origin = leave(hit.position, hit.offset, way);
    RTCRay ray;
    std::memset(&ray, 0, sizeof ray);
    if (directional)
      set(ray, origin, to, kInfinity);
    else
      set(ray, origin, to - origin, kEnd);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_.embree.top(), &context, &ray);
    return ray.tfar < 0;
  }

  static glm::vec3 leave(const glm::vec3& position, const glm::vec3& offset, const glm::vec3& direction) {
    return glm::dot(offset, direction) >= 0 ? position + offset : position - offset;
  }
  static void set(RTCRay& ray, const glm::vec3& origin, const glm::vec3& direction, float far) {
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tfar = far;
    ray.mask = 0xffffffffu;
  }

  glm::vec3 lit(const Hit& hit, float specular) const {
    glm::vec3 sum(0);
    for (const Light& light : lights_) {
      const bool directional = light.kind == LightKind::directional;
      const glm::vec3 offset = light.position - hit.position;
      const float distance = glm::length(offset);
      const glm::vec3 to_light = directional ? -light.direction : offset / distance;
      const float n_dot_l = glm::dot(hit.normal, to_light);
      if (!(n_dot_l > 0)) continue;
      float strength = directional ? 1 : attenuation_factor(light.attenuation, distance);
      if (light.kind == LightKind::spot) strength *= cone(light, to_light);
      if (!(strength > 0) || occluded(hit, directional ? to_light : light.position, directional)) continue;
      const float r_dot_v = glm::dot(glm::reflect(to_light, hit.normal), hit.direction);
      const float gloss =
          specular > 0 && r_dot_v > 0 ? specular * std::pow(r_dot_v, hit.material->exponent) : 0;
      sum += light.color * (light.power * strength) * (hit.albedo * n_dot_l + gloss);
    }
    return sum;
  }

  static float cone(const Light& light, const glm::vec3& to_light) {
    const float inner = std::cos(light.inner_angle), outer = std::cos(light.outer_angle);
    const float cosine = -glm::dot(to_light, light.direction);
    if (inner <= outer) return cosine >= outer ? 1.0f : 0.0f;
    const float t = std::min(std::max((cosine - outer) / (inner - outer), 0.0f), 1.0f);
    return t * t * (3 - 2 * t);
  }

  float density(const glm::vec3& emission) const {
    return scene_.emitters.density(std::max({emission.x, emission.y, emission.z}));
  }

  glm::vec3 emitted(const Hit& hit, std::uint32_t seed, std::uint32_t index, int bounce) const {
    const auto pick = draw(index, seed, bounce, Draw::emitter_pick);
    const auto place = draw(index, seed, bounce, Draw::emitter_place);
    const EmitterPoint point =
        scene_.emitters.sample(unit_float(pick.x), unit_float(place.x), unit_float(place.y));
    const glm::vec3 way = point.position - hit.position;
    const float square = glm::dot(way, way), length = std::sqrt(square);
    const float cosine = glm::dot(hit.normal, way) / length, there = std::abs(glm::dot(point.normal, way));
    if (!(cosine > 0 && there > 0) || occluded(hit, point.position, false)) return glm::vec3(0);
    const float other = density(point.emission) * square * length / there;
    const float ours = cosine * std::numbers::inv_pi_v<float>;
    return point.emission * (ours / (ours + other));
  }

  glm::vec3 path(Hit hit, std::uint32_t seed, std::uint32_t index) const {
    glm::vec3 throughput = hit.albedo * hit.material->reflectance, sum(0);
    for (int bounce = 1; bounce <= options_.bounces && throughput != glm::vec3(0); ++bounce) {
      if (!scene_.emitters.empty()) sum += throughput * emitted(hit, seed, index, bounce);
      const auto random = draw(index, seed, bounce, Draw::direction);
      const glm::vec3 direction = cosine_direction(unit_float(random.x), unit_float(random.y), hit.normal);
      const float ours = glm::dot(direction, hit.normal) * std::numbers::inv_pi_v<float>;
      const auto next = intersect(leave(hit.position, hit.offset, direction), direction);
      if (!next) return sum + throughput * scene_.sky;
      const glm::vec3& emission = next->material->emission;
      const float other = density(emission) * next->distance * next->distance / next->facing;
      sum += throughput * (emission * (ours / (ours + other)) + lit(*next, 0));
      throughput *= next->albedo * next->material->reflectance;
      hit = *next;
    }
    return sum;
  }

  PathScene scene_;
  PathCamera camera_;
  PathTracerOptions options_;
  std::vector<Light> lights_;
  glm::vec3 background_;
};

}  // namespace

std::vector<glm::vec3> plain_path_trace(const Scene& scene, const View& view, int width, int height,
                                        const PathTracerOptions& options) {
  const PlainTracer tracer(scene, view, width, height, options);
  std::vector<glm::vec3> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels.push_back(tracer.pixel(x, y));
  return pixels;
}

}  // namespace lightbench::bench
