#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/params.h"
#include "scene/scene.h"

namespace lightbench {

class FrameContext;  // renderer/frame_context.h: what a technique draws with

/// One frame to render.
struct FrameRequest {
  const Scene& scene;  ///< at the view's time
  const View& view;
  int width = 1024;
  int height = 768;
  int samples = 1;                   ///< supersampling per axis, box-filtered in linear light
  std::set<std::string> buffers;     ///< named buffers wanted besides the image
  std::filesystem::path baked = {};  ///< folder of the objects' files, for techniques that need a bake
};

struct PassTime {
  std::string name;
  double seconds;  ///< wall clock, with the pipeline drained before and after
};

struct FrameResult {
  Image image;  ///< linear RGBA; alpha is coverage by objects
  std::vector<PassTime> passes;
  std::map<std::string, Image> buffers;  ///< linear, at the frame's size
  std::vector<std::string> warnings;
  std::string picture_hash;  ///< of the file that an external technique showed, as it was read
};

struct BufferSpec {
  std::string name;
  std::string doc;
};

/// A way to light a view: one file pair in techniques/ and one row in techniques.cpp.
struct Technique {
  std::string name;
  std::string doc;
  std::vector<ParamSpec> params;
  std::vector<ParamPreset> presets;
  std::vector<BufferSpec> buffers;
  int version = 1;  ///< raised when the same input gives another image
  std::vector<std::string>
      shaders;  ///< embedded shader files it starts from; their text is part of cache keys
  /// How many of indirect light it shows with these parameters; none where null.
  int (*bounces)(const ParamValues& params) = nullptr;
  bool needs_gl = true;
  bool needs_bake = false;  ///< draws what was baked for each object (renderer/radiance/object_bake.h)
  bool offline = false;     ///< traces paths: no technique for real time, but what these could reach
  bool limited = false;     ///< offline, and leaves out more light than that of further bounces: no ceiling
  bool external = false;    ///< shows pictures that another engine made: its times and bounces are not known
  bool shows_water = false;
  /// Why else it cannot render this scene with these parameters; see reasons_against.
  std::vector<std::string> (*unsupported)(const Scene& scene, const ParamValues& params) = nullptr;
  void (*render)(FrameContext& frame, const ParamValues& params) = nullptr;
};

/// All techniques, in the order of the documentation.
std::span<const Technique> techniques();
/// Why a technique cannot render this scene with these parameters; empty when it can.
std::vector<std::string> reasons_against(const Technique& technique, const Scene& scene,
                                         const ParamValues& params);
/// Bounces of indirect light that a technique shows with these parameters.
int technique_bounces(const Technique& technique, const ParamValues& params);
/// By name; throws Error(…, where) that names the nearest one.
const Technique& find_technique(const std::string& name, const std::string& where);

/// Hash of the technique's name, version and shader sources with everything they include.
std::string technique_fingerprint(const Technique& technique);

}  // namespace lightbench
