#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/caustics_methods.h"
#include "renderer/caustics/flux_compare.h"
#include "renderer/gl_context.h"
#include "scene/scene.h"

namespace lightbench {

struct CausticsStudyOptions {
  std::int64_t rays = 40'000'000;  ///< of the light tracer, for each light
  MapSettings maps;
  std::vector<std::string> methods;  ///< names of rows of caustics_methods(); none: all
  double most = 8;      ///< flat water's light: both sides are clipped at so much
  bool povray = false;  ///< POV-Ray's photons, too
  /// Between photons at the water's level, as a share of the water's longer side. POV-Ray gathers 20 to 100
  /// around each point, over whatever bends there, so that they must lie within few texels.
  double photon_spacing = 2e-4;
  int threads = 1;
  GlBackend backend = GlBackend::osmesa;
};

/// What a method's map of one receiver is worth.
struct MethodFigures {
  std::string method;
  FluxLikeness likeness;          ///< to the light tracer, over texels that show the receiver
  std::size_t differing = 0;      ///< texels whose light has other bits than that of the first method
  std::size_t texture_bytes = 0;  ///< 0: does not use OpenGL
  double landed = 0;              ///< flux on the whole map, over what enters the water
};

/// One light on one receiver.
struct ReceiverFigures {
  std::string receiver;
  std::string light;
  std::size_t texels = 0;                                    ///< of the map, that show the receiver
  std::size_t lit = 0, drawn = 0, sideways = 0, raised = 0;  ///< as CausticsMap
  std::size_t planes = 0;                                    ///< of slices + 1, that the receiver lies on
  std::vector<MethodFigures> methods;
};

/// Draws the maps of a scene in water with every method and compares them with rays from its lights. Throws
/// Error for a scene without water and for lights that cannot shine through it.
std::vector<ReceiverFigures> study_caustics(const Scene& scene, const CausticsStudyOptions& options,
                                            const std::function<void(const std::string&)>& progress);

/// As Markdown: a table of the receivers, then one of the methods. `scenes` names each group of figures.
std::string caustics_tables(const std::vector<std::pair<std::string, std::vector<ReceiverFigures>>>& scenes,
                            int slices);

}  // namespace lightbench
