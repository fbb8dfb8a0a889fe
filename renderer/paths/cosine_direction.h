#pragma once

#include <numbers>

#include "renderer/paths/lanes.h"

namespace lightbench {

struct CosineDirection8 {
  Vec8 unit;
  Float8 density;  ///< per steradian: cosine / pi
};

/// Directions around unit normals with a density in proportion to their cosine, from points of the unit
/// square: the concentric map of Shirley and Chiu (1997), lifted to the hemisphere.
[[gnu::always_inline]] inline CosineDirection8 cosine_direction(Float8 u, Float8 v, const Vec8& normal) {
  const Float8 a = 2 * u - 1, b = 2 * v - 1;
  const Int8 wide = abs8(a) > abs8(b);
  const Float8 radius = select(wide, a, b);
  const Float8 ratio = select(wide, b, a) / select(radius == 0, splat(1), radius);
  // Taylor series on -pi/4..pi/4: the terms left out are below 4e-7.
  const Float8 t = ratio * (std::numbers::pi_v<float> / 4), tt = t * t;
  const Float8 sine = t * (1 + tt * (-1.0f / 6 + tt * (1.0f / 120 + tt * (-1.0f / 5040))));
  const Float8 cosine = 1 + tt * (-0.5f + tt * (1.0f / 24 + tt * (-1.0f / 720 + tt * (1.0f / 40320))));
  const Float8 x = radius * select(wide, cosine, sine), y = radius * select(wide, sine, cosine);
  const Float8 z = sqrt8(max8(1 - radius * radius, splat(1e-12f)));
  // Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
  const Float8 sign = select(normal.z < 0, splat(-1), splat(1));
  const Float8 p = -1 / (sign + normal.z), q = normal.x * normal.y * p;
  const Vec8 tangent{1 + sign * normal.x * normal.x * p, sign * q, -sign * normal.x};
  const Vec8 bitangent{q, sign + normal.y * normal.y * p, -normal.y};
  return {tangent * x + bitangent * y + normal * z, z * std::numbers::inv_pi_v<float>};
}

}  // namespace lightbench
