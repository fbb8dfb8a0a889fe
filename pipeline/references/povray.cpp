#include "pipeline/references/povray.h"

#include <cassert>

#include "base/color.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/image_io.h"
#include "base/text.h"
#include "povexport/pov_scene.h"
#include "povexport/povray.h"
#include "reports/metrics/mean_error.h"

namespace lightbench {
namespace {

constexpr const char* kViewSuffix = ".pov";
constexpr const char* kSecondSuffix = "~~second.pov";

/// What is rendered, by the suffix of its file: the view, and where its noise is asked for the view again
/// with other settings.
std::vector<std::pair<std::string, PovOptions>> renderings(const ParamValues& params) {
  const PovOptions options = pov_options(params);
  std::vector<std::pair<std::string, PovOptions>> result = {{kViewSuffix, options}};
  if (options.estimate_noise) result.emplace_back(kSecondSuffix, second_opinion(options));
  return result;
}

std::string image_hash(const Image8& image) {
  return Hasher()
      .field("width", image.width)
      .field("channels", image.channels)
      .field("pixels", {reinterpret_cast<const char*>(image.data.data()), image.data.size()})
      .digest();
}

class PovExport : public SceneExport {
 public:
  explicit PovExport(const Scene& scene) : scene_(scene), assets_(pov_assets(scene)) {
    for (const auto& [name, text] : assets_.includes) parts_.emplace_back("shared " + name, hash_bytes(text));
    for (const auto& [name, image] : assets_.images)
      parts_.emplace_back("shared " + name, image_hash(pov_image(scene_, image)));
  }

  KeyParts key_parts(const ReferenceRequest& request) const override {
    KeyParts parts = parts_;
    for (const auto& [suffix, options] : renderings(request.params))
      parts.emplace_back("scene description" + suffix, hash_bytes(view_text(request, options)));
    PovrayRun run;
    run.width = request.width;
    run.height = request.height;
    run.samples = request.samples;
    parts.emplace_back("arguments", join(povray_arguments(run), " "));
    return parts;
  }

  std::vector<std::string> warnings() const override { return assets_.warnings; }

  std::vector<std::string> shared_files() const override {
    std::vector<std::string> names;
    for (const auto& [name, text] : assets_.includes) names.push_back(name);
    for (const auto& [name, image] : assets_.images) names.push_back(name);
    return names;
  }

  void write_shared(const std::filesystem::path& folder) const override {
    for (const auto& [name, text] : assets_.includes) write_file_atomic(folder / name, text);
    for (const auto& [name, image] : assets_.images) write_png(folder / name, pov_image(scene_, image));
  }

  void write_view(const ReferenceRequest& request, const std::filesystem::path& stem) const override {
    for (const auto& [suffix, options] : renderings(request.params))
      write_file_atomic(stem.string() + suffix, view_text(request, options));
  }

 private:
  std::string view_text(const ReferenceRequest& request, const PovOptions& options) const {
    assert(scene_.time == request.view.time);
    return pov_view(scene_, assets_, request.view.camera, double(request.width) / request.height, options);
  }

  const Scene& scene_;
  PovAssets assets_;
  KeyParts parts_;
};

std::unique_ptr<SceneExport> export_to_povray(const Scene& scene) {
  return std::make_unique<PovExport>(scene);
}

std::vector<std::string> povray_view_suffixes(const ParamValues& params) {
  std::vector<std::string> suffixes;
  for (const auto& [suffix, options] : renderings(params)) suffixes.push_back(suffix);
  return suffixes;
}

/// The mean error of 255 between two renderings.
double mean_difference(const Image& a, const Image& b) {
  const Image8 first = first_channels(to_srgb8(a), 3), second = first_channels(to_srgb8(b), 3);
  return *mean_error({first, second}).value;
}

ReferenceImage run_povray_reference(const ReferenceRequest& request, const ExportFiles& files) {
  PovrayRun run;
  run.program = find_povray();
  run.library = files.shared;
  run.width = request.width;
  run.height = request.height;
  run.samples = request.samples;
  run.timeout = request.timeout;
  ReferenceImage result;
  for (const auto& [suffix, options] : renderings(request.params)) {
    run.scene_file = files.view_stem.string() + suffix;
    PovrayImage made = run_povray(run);
    result.seconds += made.seconds;
    result.cpu_seconds += made.cpu_seconds;
    if (suffix == kViewSuffix) {
      result.image = std::move(made.image);
      result.warnings = std::move(made.warnings);
    } else {
      result.noise = mean_difference(result.image, made.image);
    }
  }
  return result;
}

std::string povray_tool_version() {
  return "POV-Ray " + povray_version(find_povray());
}

int povray_bounces(const ParamValues& params) {
  return pov_bounces(pov_options(params));
}

}  // namespace

ReferenceKind povray_reference() {
  return {.name = "povray",
          .doc = "POV-Ray with its radiosity: the truth that the techniques are compared with",
          .params = pov_params(),
          .presets = pov_presets(),
          .default_preset = "physical",
          .bounces = povray_bounces,
          .tool_version = povray_tool_version,
          .view_suffixes = povray_view_suffixes,
          .make_export = export_to_povray,
          .run_export = run_povray_reference};
}

}  // namespace lightbench
