#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "base/color.h"

namespace lightbench {

/// What each of two independent halves of the samples makes of a colour, linear, tells of the error of their
/// mean: |a - b| / 2 has the mean error of (a + b) / 2. Mean of the components, of 255, sRGB-encoded and
/// clamped as an 8-bit image is, but not rounded.
inline float half_error(const glm::vec3& a, const glm::vec3& b) {
  const auto shown = [](const glm::vec3& linear) {
    const glm::vec3 c = glm::clamp(linear, 0.0f, 1.0f);
    return glm::vec3(srgb_encode(c.x), srgb_encode(c.y), srgb_encode(c.z));
  };
  const glm::vec3 difference = glm::abs(shown(a) - shown(b));
  return 255 * (difference.x + difference.y + difference.z) / 6;
}

}  // namespace lightbench
