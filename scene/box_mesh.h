#pragma once

#include <string>

#include "scene/scene.h"

namespace lightbench {

/// A box with flat outward normals: 24 vertices, 12 triangles, one part.
Mesh box_mesh(const std::string& name, const Bounds& box, int material);

}  // namespace lightbench
