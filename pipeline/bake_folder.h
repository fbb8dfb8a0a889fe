#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/params.h"
#include "scene/scene.h"

namespace lightbench {

/// A folder of baked objects says in bake.json what they were baked from.
struct BakeFolder {
  std::string key;                           ///< hash of all that decides the texels
  std::map<std::string, ParamValue> params;  ///< those of the bake (renderer/radiance/bake_settings.h)
};

/// For this scene and these parameters of a technique that needs a bake.
BakeFolder bake_folder(const Scene& scene, const ParamValues& params);
void write_bake_folder(const std::filesystem::path& folder, const BakeFolder& bake);
/// Throws Error where the folder has no bake.json, or one that cannot be read.
BakeFolder read_bake_folder(const std::filesystem::path& folder);

}  // namespace lightbench
