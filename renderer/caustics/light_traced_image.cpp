#include "renderer/caustics/light_traced_image.h"

#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <optional>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "base/color.h"
#include "base/error.h"
#include "renderer/caustics/receiver_texels.h"
#include "renderer/caustics/water_light.h"
#include "renderer/paths/closest_surface.h"
#include "renderer/paths/half_error.h"
#include "renderer/paths/path_scene.h"
#include "scene/water.h"

namespace lightbench {
namespace {

/// What a light leaves on the entities, of two halves of its rays.
struct LitMaps {
  const Light& light;
  std::array<std::vector<FluxMap>, 2> halves;
  std::vector<std::vector<ReceiverTexel>> places;  ///< of each entity
};

/// The water's surface as a scene of its own.
Scene surface_scene(const Scene& scene) {
  Scene surface;
  surface.name = scene.name;
  surface.time = scene.time;
  surface.materials.emplace_back();
  surface.meshes.push_back(water_mesh(*scene.water, scene.time));
  surface.entities.push_back({"water", 0});
  return surface;
}

using Halves = std::array<glm::vec3, 2>;

struct Seen {
  Halves color;
  bool covered;  ///< by an object or the water
};

class Pictured {
 public:
  Pictured(const Scene& scene, const LightTracedOptions& options)
      : paths_(scene),
        options_(options.trace),
        surface_scene_(surface_scene(scene)),
        surface_(surface_scene_) {
    shows_surface_ = options.surface;
    for (const Light& light : scene.lights) {
      if (const std::string problem = water_light_problem(scene, light); !problem.empty())
        throw Error(problem, scene.name);
      maps_.push_back(maps_of(light));
    }
  }

  Seen along(const glm::vec3& origin, const glm::vec3& direction) const {
    const auto hit = closest_surface(paths_, origin, direction);
    if (shows_surface_)
      if (const auto water = closest_surface(surface_, origin, direction))
        if (!hit || glm::distance(water->position, glm::dvec3(origin)) <
                        glm::distance(hit->position, glm::dvec3(origin)))
          return {through(*water, direction), true};
    return hit ? Seen{radiance(*hit, direction), true} : Seen{background(), false};
  }

 private:
  Halves background() const {
    Halves halves;
    halves.fill(paths_.scene.background.color);
    return halves;
  }

  /// What the water's surface shows: from above the refracted scene and the reflected background, from below
  /// the reflected scene and the refracted background.
  Halves through(const SurfaceHit& surface, const glm::vec3& direction) const {
    const glm::dvec3 way(direction);
    glm::dvec3 normal = glm::normalize(glm::dvec3(surface.surface.normal));
    const bool from_above = glm::dot(normal, way) < 0;
    if (!from_above) normal = -normal;
    const double ior(paths_.scene.water->ior), ratio = from_above ? 1 / ior : ior;
    const double passes = fresnel_transmission(way, normal, ratio);
    const auto bent = refracted(way, normal, ratio);
    const glm::vec3 into(from_above && bent ? *bent : glm::reflect(way, normal));
    const auto hit = closest_surface(paths_, glm::vec3(surface.position), into);
    Halves below = background();
    if (hit) {
      below = radiance(*hit, into);
      const glm::vec3 absorbed =
          glm::exp(-paths_.scene.water->absorption * float(glm::distance(hit->position, surface.position)));
      for (glm::vec3& half : below) half *= absorbed;
    }
    const auto share = float(from_above ? passes : 1 - passes);
    Halves result = background();
    for (std::size_t half = 0; half < 2; ++half) result[half] = glm::mix(result[half], below[half], share);
    return result;
  }

  static glm::vec3 towards(const glm::vec3& normal, const glm::vec3& direction) {
    const glm::vec3 unit = glm::normalize(normal);
    return glm::dot(unit, direction) > 0 ? -unit : unit;
  }

  /// Emission and reflected light towards where the ray came from, by each half of the rays.
  Halves radiance(const SurfaceHit& hit, const glm::vec3& direction) const {
    const Water& water = *paths_.scene.water;
    const glm::vec3 face = towards(hit.surface.face, direction);
    const glm::vec3 normal = towards(hit.surface.normal, direction);
    Halves result;
    result.fill(hit.surface.material->emission);
    const bool dry = hit.position.y > double(water.height);
    for (std::size_t half = 0; half < result.size(); ++half) {
      result[half] += water.ambient * hit.surface.albedo;
      for (const LitMaps& maps : maps_)
        result[half] += hit.surface.albedo * glm::vec3(dry ? direct(maps.light, hit, face, normal)
                                                           : landed(maps, half, hit, face, normal));
    }
    return result;
  }

  LitMaps maps_of(const Light& light) {
    LitMaps maps{light, {}, {}};
    LightTraceOptions half = options_;
    half.rays = options_.rays / 2;
    for (std::vector<FluxMap>& which : maps.halves) {
      which = trace_light(paths_.scene, light, half).maps;
      half.seed += 0x5851f42d4c957f2du;
    }
    for (std::size_t entity = 0; entity < paths_.scene.entities.size(); ++entity)
      maps.places.push_back(receiver_texels(paths_, maps.halves[0][entity].box, entity, options_.map_size));
    return maps;
  }

  glm::dvec3 direct(const Light& light, const SurfaceHit& hit, const glm::vec3& face,
                    const glm::vec3& normal) const {
    const Incidence incidence = incidence_at(light, hit.position);
    const double cosine = -glm::dot(incidence.direction, glm::dvec3(normal));
    const glm::vec3 to_light(-incidence.direction);
    if (cosine <= 0 || glm::dot(face, to_light) <= 0) return glm::dvec3(0);
    const double size = double(world_bounds(paths_.scene).diagonal());
    const glm::vec3 start(hit.position + 1e-5 * size * glm::dvec3(face));
    const auto hinders = closest_surface(paths_, start, to_light);
    if (hinders &&
        (light.kind == LightKind::directional || glm::distance(hinders->position, hit.position) <
                                                     glm::distance(glm::dvec3(light.position), hit.position)))
      return glm::dvec3(0);
    return incidence.irradiance * cosine;
  }

  /// As techniques/caustics/cast.frag.glsl has it.
  glm::dvec3 landed(const LitMaps& maps, std::size_t half, const SurfaceHit& hit, const glm::vec3& face,
                    const glm::vec3& normal) const {
    const FluxMap& map = maps.halves[half][hit.entity];
    const ReceiverBox& box = map.box;
    const double cosine = glm::dot(glm::dvec3(normal), box.v), across = glm::dot(glm::dvec3(face), box.v);
    if (cosine <= 0 || across <= 0) return glm::dvec3(0);
    const glm::dvec3 place = box.to_map(hit.position);
    const glm::dvec2 slope = glm::dvec2(glm::dot(glm::dvec3(face), box.u) * box.size.x,
                                        glm::dot(glm::dvec3(face), box.w) * box.size.z) /
                             (across * box.size.y);
    const double step = 1.0 / map.size;
    const double bias = 0.5 * step * (std::abs(slope.x) + std::abs(slope.y)) +
                        step * std::max(box.size.x, box.size.z) / box.size.y;
    const glm::dvec2 texel = glm::dvec2(place) * double(map.size) - 0.5, first = glm::floor(texel);
    const glm::dvec2 part = texel - first;
    glm::dvec3 sum(0);
    double weights = 0;
    for (int i = 0; i < 4; ++i) {
      const glm::dvec2 corner(i & 1, i >> 1);
      const glm::ivec2 at(first + corner);
      if (at.x < 0 || at.y < 0 || at.x >= map.size || at.y >= map.size) continue;
      const std::size_t index = std::size_t(at.y) * std::size_t(map.size) + std::size_t(at.x);
      const ReceiverTexel& shown = maps.places[hit.entity][index];
      const double expected = place.z + glm::dot((first + corner - texel) * step, slope);
      if (!shown.own || std::abs(double(shown.depth) - expected) > bias) continue;
      const glm::dvec2 near = glm::mix(1.0 - part, part, corner);
      sum += near.x * near.y * glm::dvec3(map.texels[index]);
      weights += near.x * near.y;
    }
    return weights > 0 ? sum * (cosine / weights) : glm::dvec3(0);
  }

  PathScene paths_;
  const LightTraceOptions& options_;
  Scene surface_scene_;
  PathScene surface_;
  bool shows_surface_ = true;
  std::vector<LitMaps> maps_;
};

}  // namespace

std::string light_tracer_version() {
  return fmt::format("light tracer {}, Embree {}", kLightTracerVersion, RTC_VERSION_STRING);
}

LightTracedImage light_traced_image(const Scene& scene, const View& view, int width, int height,
                                    int supersampling, const LightTracedOptions& options) {
  if (!scene.water) throw Error("the scene has no water: nothing to trace light through", scene.name);
  const Pictured pictured(scene, options);
  const PathCamera camera(view.camera, width * supersampling, height * supersampling);
  std::array<Image, 2> halves{Image(width * supersampling, height * supersampling, 4),
                              Image(width * supersampling, height * supersampling, 4)};
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int y = next++; y < halves[0].height; y = next++)
      for (int x = 0; x < halves[0].width; ++x) {
        const glm::vec3 direction = camera.direction(x, y);
        const Seen seen = pictured.along(camera.position(), direction);
        for (std::size_t half = 0; half < 2; ++half) {
          const auto pixel = halves[half].pixel(x, y);
          for (int c = 0; c < 3; ++c) pixel[std::size_t(c)] = seen.color[half][c];
          pixel[3] = seen.covered ? 1.0f : 0.0f;
        }
      }
  };
  std::vector<std::future<void>> helpers;
  for (int i = 1; i < options.trace.threads; ++i) helpers.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& helper : helpers) helper.get();
  LightTracedImage result{box_downsample(halves[0], supersampling), 0};
  const Image other = box_downsample(halves[1], supersampling);
  double error = 0;
  for (std::size_t i = 0; i < other.data.size(); i += 4) {
    const glm::vec3 a(result.image.data[i], result.image.data[i + 1], result.image.data[i + 2]);
    const glm::vec3 b(other.data[i], other.data[i + 1], other.data[i + 2]);
    error += double(half_error(a, b));
    for (std::size_t c = 0; c < 3; ++c) result.image.data[i + c] = 0.5f * (a[int(c)] + b[int(c)]);
  }
  result.noise = error / (double(width) * height);
  return result;
}

std::vector<ParamSpec> light_tracer_params() {
  const LightTraceOptions defaults;
  return {
      integer_param("rays", defaults.rays, 1000, 2'000'000'000,
                    "through the water, of each light; about so many"),
      integer_param("map_size", defaults.map_size, 16, 8192,
                    "texels along an edge of the maps that rays land in"),
      boolean_param("fresnel", defaults.fresnel, "whether the water reflects a part of the light"),
      boolean_param("surface", true,
                    "show the water's surface: what is below it refracted, and the background reflected"),
      integer_param("seed", int(defaults.seed), 0, 2147483647, "of the random choices"),
  };
}

LightTracedOptions light_tracer_options(const ParamValues& params) {
  LightTracedOptions options;
  options.trace.rays = params.integer("rays");
  options.trace.map_size = params.integer("map_size");
  options.trace.fresnel = params.boolean("fresnel");
  options.trace.seed = std::uint64_t(params.integer("seed"));
  options.surface = params.boolean("surface");
  return options;
}

}  // namespace lightbench
