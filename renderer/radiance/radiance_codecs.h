#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/params.h"
#include "renderer/radiance/radiance_objects.h"

/// How baked radiance is kept, read by a shader, and named in files: a row for each codec.
namespace lightbench {

/// The rows of parameter `codec` and of what each codec asks for.
std::vector<ParamSpec> codec_params();
/// What the shaders of techniques/surface_radiance are compiled with: CODEC_RAW and so on.
ShaderDefines codec_defines(const ParamValues& params);

/// An object's files, uploaded.
struct RadianceFile {
  int width, height;
  DirectionGrid grid;
  float scale;
  std::unique_ptr<RadianceTextures> textures;
};
/// `stem` is their path without extension. Throws Error with the file's name.
RadianceFile load_radiance(const std::filesystem::path& stem, const ParamValues& params);

}  // namespace lightbench
