#include "scene/views/drawing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/nearest_surface.h"

namespace lightbench {

Rounding::Rounding(double diagonal) : step_(std::pow(10.0, std::floor(std::log10(1e-4 * diagonal)))) {}

glm::vec3 Rounding::operator()(const glm::dvec3& p) const {
  glm::vec3 result;
  for (int k = 0; k < 3; ++k)
    result[k] = float(std::stod(fmt::format("{:.12g}", std::round(p[k] / step_) * step_)));
  return result;
}

std::size_t random_index(std::size_t count, RawRandom& random) {
  return std::min(std::size_t(random.unit() * double(count)), count - 1);
}

std::optional<glm::dvec3> random_vertex(const Scene& scene, RawRandom& random) {
  const Entity& entity = scene.entities[random_index(scene.entities.size(), random)];
  const Mesh& mesh = scene.meshes[std::size_t(entity.mesh)];
  if (mesh.triangles.empty()) return std::nullopt;
  const auto index = random_index(mesh.triangles.size(), random);
  return glm::dvec3(transform_point(entity.transform, mesh.positions[mesh.triangles[index].x]));
}

namespace {

// "87 % of the picture are background" counts as one reason whatever the number.
std::string without_numbers(std::string reason) {
  reason.erase(std::remove_if(reason.begin(), reason.end(), [](char c) { return c >= '0' && c <= '9'; }),
               reason.end());
  return reason;
}

}  // namespace

void Refusals::add(const std::string& reason) {
  ++tries_;
  Alike& alike = alike_[without_numbers(reason)];
  ++alike.count;
  alike.example = reason;
}

std::string Refusals::most_frequent() const {
  const auto most = std::max_element(alike_.begin(), alike_.end(), [](const auto& a, const auto& b) {
    return a.second.count < b.second.count;
  });
  if (most == alike_.end()) return "nothing was tried";
  return fmt::format("{} times like this: {}", most->second.count, most->second.example);
}

}  // namespace lightbench
