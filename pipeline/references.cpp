#include "pipeline/references.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/image_io.h"
#include "base/text.h"
#include "pipeline/tables.h"
#include "povexport/pov_scene.h"
#include "povexport/povray.h"

namespace lightbench {
namespace {

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
    for (const auto& [name, image] : assets_.images) parts_.emplace_back("shared " + name, image_hash(image));
  }

  KeyParts key_parts(const ReferenceRequest& request) const override {
    KeyParts parts = parts_;
    parts.emplace_back("scene description", hash_bytes(view_text(request)));
    PovrayRun run;
    run.width = request.width;
    run.height = request.height;
    run.samples = request.samples;
    parts.emplace_back("arguments", join(povray_arguments(run), " "));
    return parts;
  }

  std::vector<std::string> warnings() const override { return assets_.warnings; }

  std::vector<std::string> write_shared(const std::filesystem::path& folder) const override {
    std::vector<std::string> names;
    for (const auto& [name, text] : assets_.includes) write_file_atomic(folder / name, text);
    for (const auto& [name, text] : assets_.includes) names.push_back(name);
    for (const auto& [name, image] : assets_.images) write_png(folder / name, image);
    for (const auto& [name, image] : assets_.images) names.push_back(name);
    return names;
  }

  void write_view(const ReferenceRequest& request, const std::filesystem::path& file) const override {
    write_file_atomic(file, view_text(request));
  }

 private:
  std::string view_text(const ReferenceRequest& request) const {
    return pov_view(scene_, assets_, request.view.camera, double(request.width) / request.height,
                    pov_options(request.params));
  }

  const Scene& scene_;
  PovAssets assets_;
  KeyParts parts_;
};

std::unique_ptr<SceneExport> export_to_povray(const Scene& scene) {
  return std::make_unique<PovExport>(scene);
}

ReferenceImage run_povray_reference(const ReferenceRequest& request, const ExportFiles& files) {
  PovrayRun run;
  run.program = find_povray();
  run.scene_file = files.view_file;
  run.library = files.shared;
  run.width = request.width;
  run.height = request.height;
  run.samples = request.samples;
  run.timeout = request.timeout;
  PovrayImage made = run_povray(run);
  return {std::move(made.image), made.seconds, made.cpu_seconds, std::move(made.log)};
}

std::string povray_tool_version() {
  return "POV-Ray " + povray_version(find_povray());
}

int povray_bounces(const ParamValues& params) {
  return pov_bounces(pov_options(params));
}

}  // namespace

std::span<const ReferenceKind> reference_kinds() {
  static const ReferenceKind table[] = {
      {.name = "povray",
       .doc = "POV-Ray with its radiosity: the truth that the techniques are compared with",
       .params = pov_params(),
       .presets = pov_presets(),
       .default_preset = "physical",
       .view_extension = ".pov",
       .bounces = povray_bounces,
       .tool_version = povray_tool_version,
       .make_export = export_to_povray,
       .run = run_povray_reference},
  };
  return table;
}

const ReferenceKind& find_reference_kind(const std::string& name, const std::string& where) {
  const auto kinds = reference_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.name == name; });
  if (found != kinds.end()) return *found;
  throw Error("unknown reference kind '" + name + "'" + did_you_mean(name, row_names(kinds)), where);
}

}  // namespace lightbench
