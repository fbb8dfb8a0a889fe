#include "renderer/caustics/light_tracer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <mutex>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "renderer/caustics/water_light.h"
#include "renderer/embree_scene.h"
#include "scene/raw_random.h"
#include "scene/water.h"

namespace lightbench {
namespace {

constexpr int kPacket = 8;

/// Sums in whole numbers do not depend on the order of what is added.
constexpr double kUnits = 0x1p52;  // that the whole flux of a light is divided into

/// What is gathered from all rays, in units.
struct Sums {
  std::vector<std::vector<std::atomic<std::int64_t>>> maps;  ///< of each entity, three for each texel
  std::array<std::atomic<std::int64_t>, 3> sent{}, landed{}, hidden{};
};

void add(std::atomic<std::int64_t>* sums, const glm::dvec3& units) {
  for (int c = 0; c < 3; ++c) sums[c].fetch_add(std::llround(units[c]), std::memory_order_relaxed);
}

glm::dvec3 color_of(const std::array<std::atomic<std::int64_t>, 3>& sums, double unit) {
  return unit * glm::dvec3(double(sums[0]), double(sums[1]), double(sums[2]));
}

/// A ray below the water.
struct Photon {
  glm::vec3 origin;
  glm::vec3 direction;
  glm::vec3 to_light;  ///< as far as the light, or as far as the scene may reach
  glm::dvec3 units;
};

class LightTracer {
 public:
  LightTracer(const Scene& scene, const Light& light, const LightTraceOptions& options)
      : scene_(scene),
        light_(light),
        options_(options),
        mesh_(water_mesh(*scene.water, scene.time)),
        embree_(scene),
        reach_(2 * world_bounds(scene).diagonal() + 1),
        crest_(highest_crest(*scene.water)) {
    for (std::size_t i = 0; i < scene.entities.size(); ++i) boxes_.push_back(receiver_box(scene, i, light));
    const std::int64_t triangles = std::int64_t(mesh_.triangles.size());
    strata_ = std::max(1, int(std::lround(std::sqrt(double(options.rays) / double(triangles)))));
    sums_.maps.resize(boxes_.size());
    for (auto& map : sums_.maps)
      map = std::vector<std::atomic<std::int64_t>>(3 * std::size_t(options.map_size) *
                                                   std::size_t(options.map_size));
    unit_ = whole_flux() / kUnits;
  }

  LightTrace trace(const std::function<void(double)>& progress) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::size_t done = 0;
    const auto work = [&] {
      for (std::size_t t = next++; t < mesh_.triangles.size(); t = next++) {
        trace_triangle(t);
        const std::lock_guard lock(mutex);
        if (progress) progress(double(++done) / double(mesh_.triangles.size()));
      }
    };
    std::vector<std::future<void>> helpers;
    for (int i = 1; i < options_.threads; ++i) helpers.push_back(std::async(std::launch::async, work));
    work();
    for (std::future<void>& helper : helpers) helper.get();
    return result();
  }

 private:
  double whole_flux() const {
    double flux = 0;
    for (const glm::vec3& part : water_light(*scene_.water, mesh_, light_, false).flux)
      flux += double(std::max({part.r, part.g, part.b}));
    return std::max(flux, std::numeric_limits<double>::min() * kUnits * 2);
  }

  void trace_triangle(std::size_t triangle) {
    RawRandom random(options_.seed * 0x9e3779b97f4a7c15u + triangle);
    std::array<Photon, kPacket> packet;
    int count = 0;
    for (int row = 0; row < strata_; ++row)
      for (int column = 0; column < strata_; ++column) {
        const double s = (row + random.unit()) / strata_, t = (column + random.unit()) / strata_;
        if (!enter(triangle, s, t, packet[std::size_t(count)])) continue;
        if (++count < kPacket) continue;
        land(packet, count);
        count = 0;
      }
    if (count > 0) land(packet, count);
  }

  /// Whether light enters the water at a point of a triangle, given in the unit square.
  bool enter(std::size_t triangle, double s, double t, Photon& photon) {
    const glm::uvec3& corners = mesh_.triangles[triangle];
    const double root = std::sqrt(s);  // evenly over the triangle
    const glm::dvec3 share(1 - root, root * (1 - t), root * t);
    const auto at = [&](const std::vector<glm::vec3>& values) {
      return share.x * glm::dvec3(values[corners.x]) + share.y * glm::dvec3(values[corners.y]) +
             share.z * glm::dvec3(values[corners.z]);
    };
    const glm::dvec3 a(mesh_.positions[corners.x]), b(mesh_.positions[corners.y]),
        c(mesh_.positions[corners.z]);
    const glm::dvec3 point = at(mesh_.positions), normal = glm::normalize(at(mesh_.normals));
    const Incidence incidence = incidence_at(light_, point);
    const double across = -0.5 * glm::dot(glm::cross(b - a, c - a), incidence.direction);
    if (across <= 0 || glm::dot(normal, incidence.direction) >= 0) return false;
    const double ratio = 1 / double(scene_.water->ior);
    const double passes = options_.fresnel ? fresnel_transmission(incidence.direction, normal, ratio) : 1;
    photon.origin = glm::vec3(point);
    photon.direction = glm::vec3(*refracted(incidence.direction, normal, ratio));
    photon.to_light = light_.kind == LightKind::directional ? -reach_ * glm::vec3(incidence.direction)
                                                            : light_.position - photon.origin;
    photon.units = incidence.irradiance * (across * passes / (double(strata_) * strata_ * unit_));
    return true;
  }

  void land(const std::array<Photon, kPacket>& packet, int count) {
    std::array<bool, kPacket> lit =
        unhindered(packet, count, [](const Photon& p) { return std::pair(p.origin, p.to_light); });
    RTCRayHit8 rays;
    alignas(32) std::array<int, kPacket> valid{};  // as Embree asks
    for (int i = 0; i < count; ++i) {
      if (!lit[std::size_t(i)]) continue;
      const Photon& photon = packet[std::size_t(i)];
      valid[std::size_t(i)] = -1;
      add(sums_.sent.data(), photon.units);
      set(rays.ray, i, photon.origin, photon.direction, 0, std::numeric_limits<float>::infinity());
      rays.hit.geomID[i] = rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect8(valid.data(), embree_.top(), &context, &rays);
    std::array<Landing, kPacket> landings;
    int landed = 0;
    for (int i = 0; i < count; ++i) {
      if (valid[std::size_t(i)] == 0 || rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
      const Photon& photon = packet[std::size_t(i)];
      const Entity* entity =
          embree_.triangle(rays.hit.instID[0][i], rays.hit.geomID[i], rays.hit.primID[i]).place->entity;
      const double way = double(rays.ray.tfar[i]);
      landings[std::size_t(landed++)] = {
          std::size_t(entity - scene_.entities.data()), photon.origin + rays.ray.tfar[i] * photon.direction,
          photon.units * glm::exp(-way * glm::dvec3(scene_.water->absorption))};
    }
    deposit(landings, landed);
  }

  struct Landing {
    std::size_t entity;
    glm::vec3 point;
    glm::dvec3 units;
  };

  void deposit(const std::array<Landing, kPacket>& landings, int count) {
    const std::array<bool, kPacket> seen = unhindered(landings, count, [&](const Landing& landing) {
      // As far as the water reaches: maps show what is in it.
      const glm::dvec3& axis = boxes_[landing.entity].v;
      const double way = std::max(0.0, (crest_ - double(landing.point.y)) / axis.y);
      return std::pair(landing.point, glm::vec3(way * axis));
    });
    for (int i = 0; i < count; ++i) {
      const Landing& landing = landings[std::size_t(i)];
      add(sums_.landed.data(), landing.units);
      if (!seen[std::size_t(i)]) {
        add(sums_.hidden.data(), landing.units);
        continue;
      }
      const glm::dvec3 place = boxes_[landing.entity].to_map(glm::dvec3(landing.point));
      const auto texel = [&](double x) {
        return std::size_t(std::clamp(int(x * options_.map_size), 0, options_.map_size - 1));
      };
      add(&sums_.maps[landing.entity][3 * (texel(place.y) * std::size_t(options_.map_size) + texel(place.x))],
          landing.units);
    }
  }

  /// Of each item, whether nothing stands on the segment that `segment` gives of it: origin and way.
  template <typename Item, typename Segment>
  std::array<bool, kPacket> unhindered(const std::array<Item, kPacket>& items, int count,
                                       const Segment& segment) {
    RTCRay8 rays;
    alignas(32) std::array<int, kPacket> valid{};  // as Embree asks
    for (int i = 0; i < count; ++i) {
      valid[std::size_t(i)] = -1;
      const auto [origin, way] = segment(items[std::size_t(i)]);
      set(rays, i, origin, way, kOff, 1 - kOff);
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded8(valid.data(), embree_.top(), &context, &rays);
    std::array<bool, kPacket> free{};
    for (int i = 0; i < count; ++i) free[std::size_t(i)] = rays.tfar[i] >= 0;
    return free;
  }

  template <typename Ray>
  static void set(Ray& ray, int i, const glm::vec3& origin, const glm::vec3& direction, float near,
                  float far) {
    ray.org_x[i] = origin.x, ray.org_y[i] = origin.y, ray.org_z[i] = origin.z;
    ray.dir_x[i] = direction.x, ray.dir_y[i] = direction.y, ray.dir_z[i] = direction.z;
    ray.tnear[i] = near;
    ray.tfar[i] = far;
    ray.mask[i] = 0xffffffffu;
    ray.time[i] = 0;
    ray.flags[i] = 0;
    ray.id[i] = unsigned(i);
  }

  LightTrace result() const {
    LightTrace result;
    result.rays = std::int64_t(mesh_.triangles.size()) * strata_ * strata_;
    result.sent = color_of(sums_.sent, unit_);
    result.landed = color_of(sums_.landed, unit_);
    result.hidden = color_of(sums_.hidden, unit_);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const std::size_t texels = std::size_t(options_.map_size) * std::size_t(options_.map_size);
      const double area = boxes_[i].size.x * boxes_[i].size.z / double(texels);
      FluxMap map{boxes_[i], options_.map_size, {}};
      for (std::size_t texel = 0; texel < texels; ++texel) {
        const auto* sums = &sums_.maps[i][3 * texel];
        map.texels.emplace_back(glm::dvec3(double(sums[0]), double(sums[1]), double(sums[2])) *
                                (unit_ / area));
      }
      result.maps.push_back(std::move(map));
    }
    return result;
  }

  static constexpr float kOff = 1e-5f;  // of a segment, at both ends: off what it begins on

  const Scene& scene_;
  const Light& light_;
  const LightTraceOptions& options_;
  Mesh mesh_;
  EmbreeScene embree_;
  float reach_;
  double crest_;
  std::vector<ReceiverBox> boxes_;
  int strata_;
  double unit_;
  Sums sums_;
};

}  // namespace

LightTrace trace_light(const Scene& scene, const Light& light, const LightTraceOptions& options,
                       const std::function<void(double)>& progress) {
  return LightTracer(scene, light, options).trace(progress);
}

}  // namespace lightbench
