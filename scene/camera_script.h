#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/json_reader.h"
#include "scene/scene.h"

namespace lightbench {

/// {"views": [{"name", "position", "look_at", "up", "fov", "time", "frame", "keyframes"}]}, fov vertical in
/// degrees. Names are unique, the position is not the look_at, up is not along the view, 0.001 <= fov <=
/// 179.9: otherwise Error with its place. Of a view with keyframes this holds for each of them and for its
/// time.
std::vector<View> read_camera_script(const std::filesystem::path& file);

/// One view object of a script or a job.
View read_view(const JsonValue& value);

/// How a script's views were drawn at random, for its readers; nothing depends on it.
struct DrawnBy {
  std::uint64_t seed = 1;
  int version = 1;  ///< of the generator (scene/random_views.h)
};

/// The script as text that `read_camera_script` reads back to the same floats.
std::string camera_script_text(const std::vector<View>& views, const std::optional<DrawnBy>& drawn = {});

}  // namespace lightbench
