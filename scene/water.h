#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

/// The shape of a scene's water, and how light passes through it.
namespace lightbench {

/// Above a point of the rectangle (x, z), in the world.
double water_level(const Water& water, const glm::dvec2& place, double time);

/// No wave of it is ever higher, nor is any trough as far below its height.
double highest_crest(const Water& water);

/// Unit, upwards, from the waves' derivatives.
glm::dvec3 water_normal(const Water& water, const glm::dvec2& place, double time);

/// 0.25 depth sum(a k^2), k being 2 pi over the wavelength: the depth over the one at which crests focus
/// light from straight above.
double focusing_strength(const Water& water, double depth);

/// Vertices along x, then z, with the waves' own normals; triangles wound so that their front is the upper
/// side, with their diagonals all one way. It has one part, of material 0.
Mesh water_mesh(const Water& water, double time);

/// The direction of a ray of light after a surface, both unit; `normal` is on the side that the light comes
/// from, and `ratio` is the index of refraction there over that beyond (the water caustics thesis, eq. 2-8).
/// None where all is reflected.
std::optional<glm::dvec3> refracted(const glm::dvec3& direction, const glm::dvec3& normal, double ratio);

/// The share of unpolarised light that passes a surface of a dielectric (Fresnel), with such arguments; 0
/// where all is reflected.
double fresnel_transmission(const glm::dvec3& direction, const glm::dvec3& normal, double ratio);

}  // namespace lightbench
