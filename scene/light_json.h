#pragma once

#include "base/json_reader.h"
#include "scene/problem_list.h"
#include "scene/scene.h"

namespace lightbench {

/// What an entry of a scene file's lights describes.
struct LightEntry {
  Light light;
  /// "emitter": "lambert" of an area light: it is meant as a surface that emits colour * power
  /// (`add_emitting_surface`) and does not belong into Scene::lights.
  bool emitting_surface = false;
};

/// Lists what is wrong with its keys; throws Error with the JSON path when it is not an object.
LightEntry read_light(const JsonValue& value, ProblemList& problems);

}  // namespace lightbench
