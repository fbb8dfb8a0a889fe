#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "scene/raw_random.h"
#include "scene/scene.h"

/// What the generators of random views draw with. All versions use it, so it must go on giving the same
/// numbers.
namespace lightbench {

/// Makes short decimal numbers, coarse enough that the last bit of a sine does not matter.
class Rounding {
 public:
  explicit Rounding(double diagonal);
  glm::vec3 operator()(const glm::dvec3& p) const;

 private:
  double step_;
};

/// 0 <= index < count.
std::size_t random_index(std::size_t count, RawRandom& random);

/// A corner of some triangle of some entity, or nothing where that entity has none.
std::optional<glm::dvec3> random_vertex(const Scene& scene, RawRandom& random);

/// Counts why candidates were refused. Reasons that differ only in their numbers are one.
class Refusals {
 public:
  void add(const std::string& reason);
  int tries() const { return tries_; }
  /// "12 times like this: ..." of the most frequent reason.
  std::string most_frequent() const;

 private:
  struct Alike {
    int count = 0;
    std::string example;
  };
  std::map<std::string, Alike> alike_;
  int tries_ = 0;
};

}  // namespace lightbench
