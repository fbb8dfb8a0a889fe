#pragma once

namespace lightbench {

/// What is baked of an object.
struct ObjectSize {
  double texels;  ///< about
  int directions;
};

}  // namespace lightbench
