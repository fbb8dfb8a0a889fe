#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/gl_context.h"
#include "reports/slicing_report.h"
#include "scene/scene.h"

namespace lightbench {

struct SlicingStudyOptions {
  std::vector<int> planes{11, 26, 51, 101};  ///< by how many a receiver's box is cut, 2 and more
  int rounds = 3;
  int map_size = 512;
  int layers = 2;                    ///< of the position map
  std::vector<std::string> methods;  ///< names of rows of caustics_methods(); none: all
  std::vector<std::string> without;  ///< names of receivers that are left out
  GlBackend backend = GlBackend::osmesa;
};

/// Times rows of caustics_methods() on each receiver of a scene in water under each light: a frame of
/// each to warm up, of which the light is compared, then rounds in which they take turns. Throws Error for a
/// scene without water and for lights that cannot shine through it.
std::vector<SlicedReceiver> study_slicing(const Scene& scene, const SlicingStudyOptions& options,
                                          const std::function<void(const std::string&)>& progress);

}  // namespace lightbench
