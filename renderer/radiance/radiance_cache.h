#pragma once

#include <filesystem>
#include <list>

#include "base/params.h"
#include "renderer/radiance/radiance_objects.h"
#include "scene/scene.h"

namespace lightbench {

/// The baked objects that were drawn last, on the GPU: as many sets of them as fit.
class RadianceCache {
 public:
  /// Reads and uploads what is not there. The reference is good until the next call. Throws Error as
  /// RadianceObjects does.
  const RadianceObjects& get(const Scene& scene, const std::filesystem::path& folder,
                             const ParamValues& params);

 private:
  std::list<RadianceObjects> kept_;  ///< the last used first
};

}  // namespace lightbench
