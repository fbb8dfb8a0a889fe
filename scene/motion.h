#pragma once

#include <vector>

#include "scene/scene.h"

/// Keyframes over time. Between two of them everything goes linearly: points, scales, and each angle for
/// itself, so that a turn from 0 to 360 degrees is one. Before the first and after the last all stand still.
namespace lightbench {

/// The camera of a view that has keyframes. It need not be a possible one: `camera_problem` tells.
Camera camera_at(const std::vector<CameraKey>& keys, double time);

/// Why a camera has no frame (its position is its look_at, or up is along the view); empty where it has one.
std::string camera_problem(const Camera& camera);

/// A view with its camera and its time as they are at `time`; a still camera stays where it is. Throws Error
/// with the view's place where the camera is not possible then.
View view_at(const View& view, double time);

/// The transform of a moving entity.
glm::mat4 transform_at(const Motion& motion, double time);

bool moves(const Scene& scene);

/// Puts the moving entities where they stand at `time`. Whoever draws a view does so at the view's time.
void set_time(Scene& scene, double time);

/// Holds all that the scene's entities reach at any time, whatever its time is now; `world_bounds` where
/// nothing moves.
Bounds swept_bounds(const Scene& scene);

}  // namespace lightbench
