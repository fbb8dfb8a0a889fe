#pragma once

#include <vector>

#include "scene/scene.h"

namespace lightbench {

/// The light as lights without extent. An area light is the mean over fixed points of its surface (the
/// middles of a quad's grid cells, the centroids of a triangle's equal parts): each becomes a point light
/// with its share of the power, without an emitter's cosine. Any other light stays as it is.
std::vector<Light> light_points(const Light& light);

/// The same for all lights of the scene, in order.
std::vector<Light> light_points(const Scene& scene);

}  // namespace lightbench
