#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "renderer/radiance/texel_cover.h"
#include "scene/scene.h"

/// The map between an object's surface and the texels of a texture.
namespace lightbench {

/// Which charts the surface is cut into.
enum class AtlasUvs {
  charts,    ///< own ones: rectangles of two triangles, or halves of rectangles (surface_charts.h)
  own,       ///< the mesh's UVs, stretched to fill the texture (own_uvs.h)
  automatic  ///< the mesh's UVs where they can serve, else charts
};

struct TexelsPerUnit {
  float value;  ///< of length in world space, > 0
};
/// Width and height in texels, 1 to kMaxAtlasSide (chart_layout.h), or what follows from a density.
using AtlasSize = std::variant<glm::ivec2, TexelsPerUnit>;

/// Row 0 is the first row of the file; in a texture uploaded in that order, texture coordinates are texel
/// coordinates over width and height, without a flip.
///
/// Lookups are bilinear, between the four texels whose centres are around a point. Those with a weight are,
/// for each point of a triangle of a chart, all in `surface` or `gutters`, and belong to that chart alone.
/// Charts reach from texel centre to texel centre: two triangles that share a vertex have a texel each right
/// there, so that radiance meets at seams, and rectangles need no gutters. A texel on an edge must not look
/// behind the wall that it touches: sample at `inset` places.
///
/// Along its legs a triangle has at least two texels. Density is that of the lengths of legs in world space;
/// charts of few texels get more by rounding, and the smaller of two halves that share a rectangle.
struct ChartAtlas {
  int width = 0;
  int height = 0;
  bool own_uvs = false;
  /// Of each triangle's corners, in texels: texel (i, j) has its centre at (i + 0.5, j + 0.5). To be
  /// interpolated linearly over the triangle. Triangles without area have three times the same place.
  std::vector<std::array<glm::vec2, 3>> coordinates = {};
  std::vector<std::uint32_t> charts = {};  ///< of each triangle; kNoChart for those without area
  std::vector<SurfaceTexel> surface = {};  ///< by rows
  std::vector<GutterTexel> gutters = {};   ///< by rows
};

/// `where` names the object in errors. Throws Error when the size is not valid, when charts do not fit (it
/// names a size, or a density, that would do), and with AtlasUvs::own when UVs cannot serve (it says why).
ChartAtlas make_chart_atlas(const Mesh& mesh, const glm::mat4& transform, const AtlasSize& size, AtlasUvs uvs,
                            const std::string& where);

/// Why the mesh's UVs cannot serve at a size, or empty: they must lie in [0, 1] and not overlap, their pieces
/// must be so far apart that no lookup reads two of them, and wide enough to hold a texel's centre.
std::string why_not_own_uvs(const Mesh& mesh, const glm::mat4& transform, const AtlasSize& size);

/// Moved towards the triangle's centroid until it is that many texels away from the triangle's edges, or, in
/// small triangles, halfway to the centroid.
SurfaceTexel inset(const ChartAtlas& atlas, SurfaceTexel texel, float texels);

/// Completes values of any type with + and -: `surface_values` are those of atlas.surface.
template <typename Value>
std::vector<Value> gutter_values(const ChartAtlas& atlas, const std::vector<Value>& surface_values) {
  std::vector<Value> values;
  values.reserve(atlas.gutters.size());
  for (const GutterTexel& gutter : atlas.gutters)
    values.push_back(surface_values[gutter.a] + surface_values[gutter.b] - surface_values[gutter.c]);
  return values;
}

struct AtlasStatistics {
  std::size_t surface = 0;  ///< texels
  std::size_t gutter = 0;
  std::size_t empty = 0;
  double least_area = 0;  ///< world space, of a triangle per texel of its texture area; over all triangles
  double most_area = 0;
};
AtlasStatistics atlas_statistics(const ChartAtlas& atlas, const Mesh& mesh, const glm::mat4& transform);

}  // namespace lightbench
