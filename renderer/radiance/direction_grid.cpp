#include "renderer/radiance/direction_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

constexpr std::array kLayerOrders{
    LayerOrderName{LayerOrder::theta_major, "theta_major"},
    LayerOrderName{LayerOrder::phi_major, "phi_major"},
    LayerOrderName{LayerOrder::phi_serpentine, "phi_serpentine"},
};

// The square of how near to (0, -1, 0) a normal is taken for it: the shortest rotation is not defined there.
constexpr float kOpposite = 1e-12f;

bool runs_up(const DirectionGrid& grid, int i_phi) {
  return grid.order == LayerOrder::phi_serpentine && i_phi % 2 == 1;
}

}  // namespace

std::span<const LayerOrderName> layer_orders() {
  return kLayerOrders;
}

const char* name_of(LayerOrder order) {
  return kLayerOrders[std::size_t(order)].name;
}

int DirectionGrid::layer(int i_theta, int i_phi) const {
  if (order == LayerOrder::theta_major) return i_theta * phis + i_phi;
  return i_phi * thetas + (runs_up(*this, i_phi) ? thetas - 1 - i_theta : i_theta);
}

glm::ivec2 DirectionGrid::place(int layer) const {
  if (order == LayerOrder::theta_major) return {layer / phis, layer % phis};
  const int i_phi = layer / thetas, i = layer % thetas;
  return {runs_up(*this, i_phi) ? thetas - 1 - i : i, i_phi};
}

glm::vec3 DirectionGrid::direction(int i_theta, int i_phi) const {
  const double theta = std::numbers::pi / 2 * i_theta / (thetas - 1);
  const double phi = 2 * std::numbers::pi * i_phi / phis;
  return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

NearestDirections nearest_directions(const DirectionGrid& grid, const glm::vec3& local) {
  const float across = std::hypot(local.x, local.z);
  const float theta = std::atan2(across, local.y) * float(grid.thetas - 1) / (std::numbers::pi_v<float> / 2);
  const float turn = across > 0 ? std::atan2(local.z, local.x) / (2 * std::numbers::pi_v<float>) : 0;
  const float phi = (turn < 0 ? turn + 1 : turn) * float(grid.phis);
  NearestDirections nearest{};
  nearest.theta[0] = std::clamp(int(theta), 0, grid.thetas - 1);
  nearest.theta[1] = std::min(nearest.theta[0] + 1, grid.thetas - 1);
  nearest.theta_part = std::clamp(theta - float(nearest.theta[0]), 0.0f, 1.0f);
  nearest.phi[0] = int(phi) % grid.phis;  // rounding may have made a whole turn of it
  nearest.phi[1] = (nearest.phi[0] + 1) % grid.phis;
  nearest.phi_part = std::clamp(phi - float(int(phi)), 0.0f, 1.0f);
  return nearest;
}

glm::mat3 frame_of_normal(const glm::vec3& n) {
  const float across = n.x * n.x + n.z * n.z;
  if (n.y < 0 && across < kOpposite) return {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const float k = n.y < 0 ? (1 - n.y) / across : 1 / (1 + n.y);  // the same, without cancellation
  return {{1 - k * n.x * n.x, -n.x, -k * n.x * n.z}, n, {-k * n.x * n.z, -n.z, 1 - k * n.z * n.z}};
}

}  // namespace lightbench
