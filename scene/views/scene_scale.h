#pragma once

#include "scene/random_views.h"
#include "scene/scene.h"

namespace lightbench::views_2 {

/// The sizes by which version 2 draws and judges views. Scenes do not say their unit, so it is guessed.
struct SceneScale {
  Bounds bounds;
  double diagonal = 1;
  double eye_height = 1.6;     ///< over a floor
  double least_clearance = 0;  ///< of cameras, in any place: 0.2 where units look like metres
  bool is_object = false;      ///< a single thing in the open, to be looked at from around
  bool fronts_count = true;    ///< whether back faces mean the inside of a solid
};

/// Measures a scene that is not empty. Units look like metres where many places are as high as rooms are (1.9
/// to 6 units), or, in a scene without ceilings, where its diagonal is 3 to 5000 units; then eyes are 1.6
/// units over the floor. Otherwise they are in proportion to the height of its rooms, or to its diagonal.
/// An object is what has no walls around most of its places and is too small to walk about in, or of unknown
/// unit and without ceilings.
SceneScale scene_scale(const Scene& scene, const ClosestHit& closest_hit);

}  // namespace lightbench::views_2
