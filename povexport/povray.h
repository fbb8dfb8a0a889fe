#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/image.h"

namespace lightbench {

/// The program that POV-Ray references run: $LIGHTBENCH_POVRAY, or povray on the PATH. Throws Error if there
/// is none.
std::filesystem::path find_povray();
/// What it calls its version, e.g. "3.7.0.10.unofficial". Throws Error when it does not answer.
std::string povray_version(const std::filesystem::path& program);

struct PovrayRun {
  std::filesystem::path program;
  std::filesystem::path scene_file;  ///< .pov, as pov_view writes it
  std::filesystem::path library;     ///< folder of the includes and images that it names
  int width = 1024;
  int height = 768;
  int samples = 1;  ///< supersampling per axis, box-filtered in linear light
  std::chrono::milliseconds timeout{std::chrono::hours(2)};
  /// Without memory for a thread POV-Ray 3.7 may wait for ever; at work it never rests.
  std::chrono::milliseconds idle_timeout{std::chrono::minutes(1)};
};

struct PovrayImage {
  Image image;         ///< linear RGBA; alpha is coverage by objects
  double seconds = 0;  ///< wall clock
  double cpu_seconds = 0;
  std::string log;  ///< what POV-Ray said on its error stream
  std::vector<std::string> arguments;
  std::vector<std::string> warnings;  ///< about the image
};

/// The arguments that decide the image (for cache keys): without paths.
std::vector<std::string> povray_arguments(const PovrayRun& run);

/// Runs POV-Ray with one thread in a working directory of its own. Throws Error (with the last lines of its
/// error stream) for a non-zero exit, a signal, the timeout, an exit 0 without an image, and NaN in the
/// image. What is too bright for the half floats that POV-Ray writes is clamped, with a warning.
PovrayImage run_povray(const PovrayRun& run);

}  // namespace lightbench
