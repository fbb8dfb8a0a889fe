#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/radiance/bake_settings.h"
#include "renderer/radiance/chart_atlas.h"
#include "renderer/radiance/object_size.h"
#include "scene/scene.h"

namespace lightbench {

/// The directions of an entity's texels: with the settings' steps for highlights of `gloss_exponent`, which
/// are as wide as the root of their exponent is small; finer for narrower ones, up to 45 along each and to
/// 2048 together, which is as many layers of a texture as OpenGL promises.
DirectionGrid object_grid(const Scene& scene, std::size_t entity, const BakeSettings& settings);

/// The texels of an entity's surface: an atlas for the front; a stack of twice its height holds the back
/// below it, in the same places. Throws Error where the texels do not fit into a texture, or their radiance
/// into a file.
ChartAtlas object_atlas(const Scene& scene, std::size_t entity, const BakeSettings& settings);

/// Of each place of a layer of a stack of that height, 1 where the atlas has a texel.
std::vector<std::uint8_t> counting_places(const ChartAtlas& atlas, int height);

/// Those that have triangles.
std::vector<std::size_t> objects_to_bake(const Scene& scene);

/// Throws Error where a pattern of `sizes` matches none of them.
void check_named_sizes(const Scene& scene, const BakeSettings& settings);

/// What each of them will have.
std::vector<ObjectSize> expected_sizes(const Scene& scene, const BakeSettings& settings);

/// The name of an object's files in a folder of them, without extension: its number and its name, escaped.
std::string object_file_stem(const Scene& scene, std::size_t entity);

struct ObjectBake {
  HalfStack stack;  ///< of one side where nothing leaves the back
  BakeNews news;
  std::size_t texels = 0;  ///< that were traced, of the front: buried ones are not
};

/// Bakes objects of one scene, which must not change meanwhile.
class ObjectBaker {
 public:
  explicit ObjectBaker(const Scene& scene);
  ~ObjectBaker();

  /// Throws Error where the texels do not fit.
  ObjectBake bake(std::size_t entity, const BakeSettings& settings,
                  const std::function<void(double)>& progress = nullptr) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lightbench
