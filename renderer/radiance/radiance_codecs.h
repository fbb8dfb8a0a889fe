#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "renderer/radiance/codec_report.h"
#include "renderer/radiance/radiance_objects.h"

namespace lightbench {

/// How baked radiance is kept in files and read by a shader: a row of the table of codecs.
struct RadianceCodec {
  const char* name;
  std::vector<const char*> params;      ///< that decide what is in the files
  std::vector<const char*> extensions;  ///< of an object's files
  /// Writes an object's files; null where the codec draws the .mtex itself. `counts` tells of each place of a
  /// layer whether a texel is there.
  CodecReport (*compress)(const HalfStack& stack, std::span<const std::uint8_t> counts,
                          const ParamValues& params, const std::filesystem::path& stem);
  /// Reads and uploads them. `stem` is their path without extension. Throws Error with the file's name.
  RadianceFile (*load)(const std::filesystem::path& stem, const ParamValues& params);
  /// What the shaders of techniques/surface_radiance are compiled with: CODEC_RAW and so on.
  ShaderDefines (*defines)(const ParamValues& params);
};

std::span<const RadianceCodec> radiance_codecs();
/// That of parameter `codec`.
const RadianceCodec& radiance_codec(const ParamValues& params);
/// The rows of parameter `codec` and of what each codec asks for.
std::vector<ParamSpec> codec_params();
/// The part of a variant's parameters that decides a codec's files, as text: a line for each.
std::string codec_params_text(const ParamValues& params);

}  // namespace lightbench
