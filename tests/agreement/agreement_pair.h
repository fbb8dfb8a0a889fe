#pragma once

#include <cmath>
#include <cstdlib>

#include "base/color.h"
#include "base/files.h"
#include "base/image_io.h"
#include "povexport/pov_scene.h"
#include "povexport/povray.h"
#include "renderer/renderer.h"

namespace lightbench {

/// One view as both sides show it.
struct Pair {
  Image8 reference;
  Image8 snapshot;
};

/// Without radiosity; linear.
inline Image povray_image(const Scene& scene, const PovAssets& assets, const View& view,
                          const FrameRequest& frame) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : assets.includes) write_file_atomic(folder.path() / name, text);
  for (const auto& [name, image] : assets.images) write_png(folder.path() / name, pov_image(scene, image));
  PovOptions options;
  options.radiosity = false;
  PovrayRun run;
  run.program = find_povray();
  run.scene_file = folder.path() / "view.pov";
  run.library = folder.path();
  run.width = frame.width;
  run.height = frame.height;
  run.samples = frame.samples;
  const double aspect = double(frame.width) / frame.height;
  write_file_atomic(run.scene_file, pov_view(scene, assets, view.camera, aspect, options));
  return run_povray(run).image;
}

inline Image8 render_with_povray(const Scene& scene, const PovAssets& assets, const View& view,
                                 const FrameRequest& frame) {
  return to_srgb8(povray_image(scene, assets, view, frame));
}

/// With hard shadows.
inline Image8 render_direct(Renderer& renderer, const FrameRequest& frame) {
  const Technique& direct = find_technique("direct", "test");
  const ParamValues hard =
      resolve_params(direct.params, direct.presets, "", {{"shadows", std::string("hard")}}, "test");
  return to_srgb8(renderer.render(direct, hard, frame).image);
}

/// Of 255, over all pixels and the three colours.
inline double mean_error(const Pair& pair) {
  double sum = 0;
  for (std::size_t i = 0; i < pair.reference.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      sum += std::abs(int(pair.reference.data[4 * i + c]) - int(pair.snapshot.data[4 * i + c]));
  return sum / double(3 * pair.reference.pixel_count());
}

}  // namespace lightbench
