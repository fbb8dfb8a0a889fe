#include "renderer/radiance/object_bake.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/image.h"
#include "base/text.h"
#include "renderer/radiance/bake.h"
#include "renderer/radiance/baked_file.h"
#include "renderer/radiance/buried_texels.h"
#include "renderer/radiance/solids.h"

namespace lightbench {
namespace {

// How far texels on the edge of a chart are moved into it, in texels: they must not look behind a wall that
// stands there, and what they show must stay that of the edge.
constexpr float kInset = 0.1f;

// How far over a texel an object must reach to bury it, in texels: less is modelled as lying on it.
constexpr float kAbove = 0.05f;

const Mesh& mesh_of(const Scene& scene, std::size_t entity) {
  return scene.meshes[std::size_t(scene.entities[entity].mesh)];
}

double world_area(const Scene& scene, std::size_t entity) {
  const Mesh& mesh = mesh_of(scene, entity);
  const glm::dmat4 transform(scene.entities[entity].transform);
  const auto at = [&](std::uint32_t vertex) {
    return glm::dvec3(transform * glm::dvec4(mesh.positions[vertex], 1));
  };
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles)
    area += glm::length(glm::cross(at(t.y) - at(t.x), at(t.z) - at(t.x))) / 2;
  return area;
}

const NamedSize* given_size(const Scene& scene, std::size_t entity, const BakeSettings& settings) {
  for (const NamedSize& named : settings.sizes)
    if (matches_glob(scene.entities[entity].name, named.pattern)) return &named;
  return nullptr;
}

double density(const Scene& scene, const BakeSettings& settings) {
  if (settings.density > 0) return settings.density;
  double area = 0;
  for (const std::size_t entity : objects_to_bake(scene))
    if (!given_size(scene, entity, settings)) area += world_area(scene, entity);
  return area > 0 ? std::sqrt(settings.texels / area) : 1;
}

using HalfTexel = std::array<std::uint16_t, 3>;

glm::vec3 unpacked(const HalfTexel& texel) {
  return {glm::unpackHalf1x16(texel[0]), glm::unpackHalf1x16(texel[1]), glm::unpackHalf1x16(texel[2])};
}
HalfTexel packed(const glm::vec3& v) {
  const glm::vec3 c = glm::clamp(v, 0.0f, kLargestHalf);
  return {glm::packHalf1x16(c.x), glm::packHalf1x16(c.y), glm::packHalf1x16(c.z)};
}

/// Each layer's gutters; light that extrapolation makes negative is none.
void fill_gutters(const ChartAtlas& atlas, HalfStack& stack) {
  for (int layer = 0; layer < stack.grid.layers(); ++layer) {
    const auto texel = [&](const glm::ivec2& place) -> HalfTexel& {
      return stack.texels[stack.index(place.x, place.y, layer)];
    };
    const auto value = [&](std::uint32_t i) { return unpacked(texel(atlas.surface[i].place)); };
    for (const GutterTexel& gutter : atlas.gutters)
      texel(gutter.place) = packed(value(gutter.a) + value(gutter.b) - value(gutter.c));
  }
}

std::vector<BakeTexel> texels_of(const ChartAtlas& atlas, Side side) {
  std::vector<BakeTexel> texels;
  texels.reserve(atlas.surface.size());
  for (const SurfaceTexel& texel : atlas.surface) {
    const SurfaceTexel from = inset(atlas, texel, kInset);
    const int row = texel.place.y + (side == Side::back ? atlas.height : 0);
    texels.push_back({std::uint32_t(texel.place.y * atlas.width + texel.place.x),
                      std::uint32_t(row * atlas.width + texel.place.x),
                      {from.triangle, from.beta, from.gamma},
                      side});
  }
  return texels;
}

/// Layer by layer the front, then the back.
void append_back(HalfStack& front, const HalfStack& back) {
  HalfStack::Texels both;
  both.reserve(front.texels.size() + back.texels.size());
  const auto size = std::ptrdiff_t(front.layer_size());
  for (int layer = 0; layer < front.grid.layers(); ++layer)
    for (HalfStack const* side : {&std::as_const(front), &back}) {
      const auto first = side->texels.begin() + layer * size;
      both.insert(both.end(), first, first + size);
    }
  front.texels = std::move(both);
  front.height *= 2;
}

/// Before the hours that it may take to trace them.
void check_fits_in_a_file(const ChartAtlas& atlas, int directions, const std::string& where) {
  const std::uint64_t values =
      std::uint64_t(atlas.width) * std::uint64_t(atlas.height) * std::uint64_t(directions);
  if (values > kMaxBakedEntries)
    throw Error(
        fmt::format(
            "{} x {} texels of {} directions are more than a file can hold: {} instead of at most {} values",
            atlas.width, atlas.height, directions, values, kMaxBakedEntries),
        where);
}

void add(BakeNews& sum, const BakeNews& news) {
  for (std::size_t i = 0; i < sum.rays.size(); ++i) {
    sum.rays[i].rays += news.rays[i].rays;
    sum.rays[i].seconds += news.rays[i].seconds;
  }
}

}  // namespace

std::vector<std::size_t> objects_to_bake(const Scene& scene) {
  std::vector<std::size_t> objects;
  for (std::size_t i = 0; i < scene.entities.size(); ++i)
    if (!mesh_of(scene, i).triangles.empty()) objects.push_back(i);
  return objects;
}

std::vector<std::uint8_t> counting_places(const ChartAtlas& atlas, int height) {
  std::vector<std::uint8_t> counts(std::size_t(atlas.width) * std::size_t(height));
  const auto mark = [&](const glm::ivec2& place) {
    for (int row = place.y; row < height; row += atlas.height)
      counts[std::size_t(row) * std::size_t(atlas.width) + std::size_t(place.x)] = 1;
  };
  for (const SurfaceTexel& texel : atlas.surface) mark(texel.place);
  for (const GutterTexel& texel : atlas.gutters) mark(texel.place);
  return counts;
}

void check_named_sizes(const Scene& scene, const BakeSettings& settings) {
  std::vector<std::string> names;
  for (const std::size_t entity : objects_to_bake(scene)) names.push_back(scene.entities[entity].name);
  for (const NamedSize& size : settings.sizes)
    if (std::ranges::none_of(names,
                             [&](const std::string& name) { return matches_glob(name, size.pattern); }))
      throw Error(
          fmt::format("{} has no object '{}'{}", scene.name, size.pattern, did_you_mean(size.pattern, names)),
          "parameter 'sizes'");
}

DirectionGrid object_grid(const Scene& scene, std::size_t entity, const BakeSettings& settings) {
  constexpr int kMostLayers = 2048, kMostAlong = 45;  // 45 * 45 is the largest square below
  DirectionGrid grid = settings.trace.grid;
  double exponent = 0;
  for (const MeshPart& part : mesh_of(scene, entity).parts) {
    const Material& material = scene.materials[std::size_t(part.material)];
    if (material.specular > 0) exponent = std::max(exponent, double(material.exponent));
  }
  if (settings.gloss_exponent <= 0 || exponent <= settings.gloss_exponent) return grid;
  const double finer = std::sqrt(exponent / settings.gloss_exponent);
  const auto along = [&](int steps) { return int(std::min(std::ceil(steps * finer), double(kMostAlong))); };
  grid.thetas =
      std::max(grid.thetas, std::min({1 + along(grid.thetas - 1), kMostAlong, kMostLayers / grid.phis}));
  grid.phis = std::max(grid.phis, std::min(along(grid.phis), kMostLayers / grid.thetas));
  return grid;
}

std::vector<ObjectSize> expected_sizes(const Scene& scene, const BakeSettings& settings) {
  const double along = density(scene, settings);
  std::vector<ObjectSize> sizes;
  for (const std::size_t entity : objects_to_bake(scene)) {
    const NamedSize* given = given_size(scene, entity, settings);
    sizes.push_back(
        {given ? double(given->size.x) * given->size.y : along * along * world_area(scene, entity),
         object_grid(scene, entity, settings).layers()});
  }
  return sizes;
}

std::string object_file_stem(const Scene& scene, std::size_t entity) {
  return fmt::format("{:04}-{}", entity, escape_file_name(scene.entities[entity].name));
}

ChartAtlas object_atlas(const Scene& scene, std::size_t entity, const BakeSettings& settings) {
  const NamedSize* given = given_size(scene, entity, settings);
  const AtlasSize size = given ? AtlasSize(given->size) : TexelsPerUnit{float(density(scene, settings))};
  const std::string where = fmt::format("object '{}' of {}", scene.entities[entity].name, scene.name);
  ChartAtlas atlas =
      make_chart_atlas(mesh_of(scene, entity), scene.entities[entity].transform, size, settings.uvs, where);
  check_fits_in_a_file(atlas, object_grid(scene, entity, settings).layers(), where);
  return atlas;
}

struct ObjectBaker::Impl {
  explicit Impl(const Scene& scene) : paths(scene), solids(scene) {}
  PathScene paths;
  Solids solids;

  /// Where a texel's neighbours lie, about, in the world.
  float texel_size(std::size_t entity, const ChartAtlas& atlas) const {
    return float(
        std::sqrt(world_area(paths.scene, entity) / double(std::max<std::size_t>(1, atlas.surface.size()))));
  }
};

ObjectBaker::ObjectBaker(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
ObjectBaker::~ObjectBaker() = default;

ObjectBake ObjectBaker::bake(std::size_t entity, const BakeSettings& settings,
                             const std::function<void(double)>& progress) const {
  const ChartAtlas atlas = object_atlas(impl_->paths.scene, entity, settings);
  const float above = kAbove * impl_->texel_size(entity, atlas);
  BakeOptions trace = settings.trace;
  trace.grid = object_grid(impl_->paths.scene, entity, settings);
  const auto side = [&](Side which, double begin) {
    ObjectBake result;
    result.stack = {atlas.width, atlas.height, trace.grid, trace.scale, {}};
    result.stack.texels.resize(result.stack.layer_size() * std::size_t(trace.grid.layers()));
    std::vector<BakeTexel> texels = texels_of(atlas, which);
    const std::vector<bool> buried = buried_texels(impl_->paths, impl_->solids, entity, texels, above);
    std::size_t number = 0;
    std::erase_if(texels, [&](const BakeTexel&) { return bool(buried[number++]); });
    const auto half = [&](double share) { progress(begin + share / 2); };
    result.news = bake_texels(impl_->paths, entity, texels, trace, result.stack,
                              progress ? std::function<void(double)>(half) : nullptr);
    result.texels = texels.size();
    if (!result.news.lit) return result;
    fill_buried(atlas, buried, result.stack);
    fill_gutters(atlas, result.stack);
    return result;
  };
  ObjectBake result = side(Side::front, 0);
  const ObjectBake back = side(Side::back, 0.5);
  if (back.news.lit) {
    append_back(result.stack, back.stack);
    result.news.noise = std::max(result.news.noise, back.news.noise);
  }
  add(result.news, back.news);
  return result;
}

}  // namespace lightbench
