#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/image.h"
#include "base/params.h"
#include "scene/scene.h"

namespace lightbench {

/// One reference image to make.
struct ReferenceRequest {
  const View& view;
  int width = 1024;
  int height = 768;
  int samples = 1;  ///< supersampling per axis
  ParamValues params;
  std::chrono::milliseconds timeout{0};
};

/// The named parts of a cache key, in order; `plan --explain` compares them one by one.
using KeyParts = std::vector<std::pair<std::string, std::string>>;

/// Files of an export: those of the scene are shared by all its views.
struct ExportFiles {
  std::filesystem::path view_stem;  ///< the view's files without what `view_suffixes` adds
  std::filesystem::path shared;     ///< folder of what all views of the scene share
};

struct ReferenceImage {
  Image image;  ///< linear RGBA; alpha is coverage by objects
  double seconds = 0;
  double cpu_seconds = 0;
  std::optional<double> noise;              ///< estimated mean error of the 8-bit image, of 255; if known
  std::map<std::string, double> ray_rates;  ///< rays a second, by class of ray; of a path tracer
  std::vector<std::string> warnings = {};   ///< about the image
};

/// What a scene gives to all its reference views: made once, then asked many times, the scene being at the
/// time of the view that is asked for.
class SceneExport {
 public:
  virtual ~SceneExport() = default;
  /// What decides the image, but for the tool's version.
  virtual KeyParts key_parts(const ReferenceRequest& request) const = 0;
  virtual std::vector<std::string> warnings() const = 0;
  /// Names of the files that all views share.
  virtual std::vector<std::string> shared_files() const = 0;
  /// Writes them.
  virtual void write_shared(const std::filesystem::path& folder) const = 0;
  /// Writes the view's files: one for each of the kind's suffixes.
  virtual void write_view(const ReferenceRequest& request, const std::filesystem::path& stem) const = 0;
};

/// An offline renderer that gives the truth: one row in references.cpp. Either it renders the files of an
/// export with a program of its own, or it is part of lightbench and renders the scene itself.
struct ReferenceKind {
  std::string name;
  std::string doc;
  std::span<const ParamSpec> params;
  std::span<const ParamPreset> presets;
  std::string default_preset;
  int (*bounces)(const ParamValues& params) = nullptr;
  /// The program's version. Throws Error when it is not there.
  std::string (*tool_version)() = nullptr;

  /// Of the files that a view is exported to; the first one is the view itself.
  std::vector<std::string> (*view_suffixes)(const ParamValues& params) = nullptr;
  std::unique_ptr<SceneExport> (*make_export)(const Scene& scene) = nullptr;
  ReferenceImage (*run_export)(const ReferenceRequest& request, const ExportFiles& files) = nullptr;
  /// The scene is at the view's time.
  ReferenceImage (*run_scene)(const ReferenceRequest& request, const Scene& scene) = nullptr;

  bool exports() const { return make_export != nullptr; }
};

/// All kinds of references, in the order of the documentation.
std::span<const ReferenceKind> reference_kinds();
/// By name; throws Error(..., where) that names the nearest one.
const ReferenceKind& find_reference_kind(const std::string& name, const std::string& where);

}  // namespace lightbench
