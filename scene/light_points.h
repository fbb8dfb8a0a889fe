#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace lightbench {

/// The light as lights without extent. An area light is the mean over fixed points of its surface (the
/// middles of a quad's grid cells, the centroids of a triangle's equal parts): each becomes a point light
/// with its share of the power, without an emitter's cosine. Any other light stays as it is.
std::vector<Light> light_points(const Light& light);

/// The same for all lights of the scene, in order.
std::vector<Light> light_points(const Scene& scene);

/// Returns how many points `light_points` would make.
std::size_t light_point_count(const Light& light);
std::size_t light_point_count(const Scene& scene);

/// The most points of a scene's lights in all; each is a light that is computed by itself.
inline constexpr std::size_t kMostLightPoints = 100'000;

/// About how many seconds a picture takes for each point when OpenGL draws a shadow map of it. Measured on a
/// busy machine with two cores and OSMesa, for shadow maps of 2048 x 2048 texels and a picture of 32 x 24
/// pixels: 35.7 s with 256 points, 74 s with 4096.
inline constexpr double kShadowMapSeconds = 0.02;

}  // namespace lightbench
