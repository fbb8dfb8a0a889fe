#include "fuzz_input.h"
#include "scene/camera_script.h"
#include "scene/motion.h"

namespace lightbench::fuzz {

/// A camera script. What is read can be written, and reads back the same.
void fuzz_camera(std::string_view bytes) {
  static const InputFolder folder;
  const auto views = read_camera_script(folder.write("cameras.json", bytes));
  for (const View& view : views) require(camera_problem(view.camera).empty(), "a camera without a frame");
  const std::string text = camera_script_text(views);
  const auto again = read_camera_script(folder.write("again.json", text));
  require(camera_script_text(again) == text, "a camera script that reads back as another one");
}

}  // namespace lightbench::fuzz
