#pragma once

/// Attenuation by radius at some distances, worked out by hand from saturate(1 - (d / r)^2): whatever
/// computes it is held against these numbers, since sides that share a mistake agree with one another.
namespace lightbench::test {

struct RadiusFactor {
  float part;  ///< d / r
  float factor;
};

inline constexpr RadiusFactor kRadiusFactors[] = {{0, 1},           {0.25f, 0.9375f}, {0.5f, 0.75f},
                                                  {0.75f, 0.4375f}, {1, 0},           {1.25f, 0}};

/// The radius of a light of which a surface at distance `d` lies at `part` of it. No surface lies at 0 of a
/// radius; at a ten-thousandth the factor is 1 to eight digits.
inline float radius_for(float d, float part) {
  return d / (part > 0 ? part : 1e-4f);
}

}  // namespace lightbench::test
