#pragma once

#include <span>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// The directions in which a texel's radiance is kept: a grid over the hemisphere about its shading normal
/// (surface-radiance thesis, 5.1).
namespace lightbench {

/// In which order the directions of a texel follow one another, as layers of a texture.
enum class LayerOrder {
  theta_major,    ///< index = i_theta * phis + i_phi (eq. 4.2)
  phi_major,      ///< index = i_phi * thetas + i_theta
  phi_serpentine  ///< phi_major, but with every second column of theta from the horizon up: neighbours in the
                  ///< order are neighbours on the hemisphere
};

struct LayerOrderName {
  LayerOrder order;
  const char* name;
};
/// By value: the number in files is the place in this table.
std::span<const LayerOrderName> layer_orders();
const char* name_of(LayerOrder order);

/// theta_i = 90 i / (thetas - 1) degrees from the normal, 0 <= i < thetas; phi_j = 360 j / phis degrees.
struct DirectionGrid {
  int thetas = 20;  ///< 2 to kMaxThetas; the first are all the normal itself, the last the horizon
  int phis = 20;    ///< 1 to kMaxPhis
  LayerOrder order = LayerOrder::phi_serpentine;

  int layers() const { return thetas * phis; }
  int layer(int i_theta, int i_phi) const;
  /// (i_theta, i_phi) of a layer.
  glm::ivec2 place(int layer) const;
  /// Unit, in the local frame, where y is the normal; phi turns from x to z.
  glm::vec3 direction(int i_theta, int i_phi) const;

  bool operator==(const DirectionGrid&) const = default;
};
inline constexpr int kMaxThetas = 256;
inline constexpr int kMaxPhis = 256;  // so that a layer's number has 16 bits

/// The four directions around one, and their weights, which add up to 1. Phi wraps around; below the horizon
/// the horizon counts. At the pole, where all phi are one direction, any of them will do.
struct NearestDirections {
  glm::ivec2 theta, phi;       ///< lower and upper index
  float theta_part, phi_part;  ///< of the upper ones, 0..1
};
/// `local` is of any length but 0.
NearestDirections nearest_directions(const DirectionGrid& grid, const glm::vec3& local);

/// The rotation that takes (0, 1, 0) to a unit normal, the shortest one; for (0, -1, 0) half a turn about x.
glm::mat3 frame_of_normal(const glm::vec3& normal);

}  // namespace lightbench
