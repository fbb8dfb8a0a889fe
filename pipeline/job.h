#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/params.h"
#include "reports/verdict.h"
#include "scene/random_views.h"
#include "scene/scene.h"

/// What a job file says (jobs/FORMAT.md), with defaults filled in and every name checked.
namespace lightbench {

/// Views that are drawn at random, the same for the same seed and version.
struct RandomViewsRequest {
  int count = 1;
  std::uint64_t seed = 1;
  double fov = 60;  ///< vertical, degrees
  int version = kNewestGenerator;
};

/// All views of a camera script, or those that are named.
struct CameraScript {
  std::filesystem::path file;
  std::vector<std::string> names;  ///< empty: all
};

/// A camera script, views written out in the job, or a request to draw some.
using JobViews = std::variant<CameraScript, std::vector<View>, RandomViewsRequest>;

inline constexpr int kMaxFrames = 1000;
inline constexpr double kMinFrameRate = 0.001;
inline constexpr double kMaxFrameRate = 1000;

/// Frames that each view of a scene is drawn in, as views of their own.
struct JobSequence {
  double start = 0;  ///< seconds
  int frames = 2;
  double rate = 12;  ///< frames a second
};

struct JobScene {
  std::string name;            ///< unique in the job
  std::string as_written;      ///< the scene's path as the job has it
  std::filesystem::path file;  ///< the same, resolved
  JobViews views;
  std::optional<JobSequence> sequence;  ///< of a concrete job: none, its views are the frames
};

using GivenParams = std::map<std::string, ParamValue>;

struct JobVariant {
  std::string name;  ///< unique among variants and references
  std::string technique;
  std::string preset;                                                  ///< empty: the defaults
  GivenParams params;                                                  ///< what the job gives
  std::vector<std::pair<std::string, std::vector<ParamValue>>> sweep;  ///< one variant for each combination
  std::string swept_from;  ///< of a variant that a sweep made: the name it had in the job
};

struct JobReference {
  std::string name;
  std::string kind;
  std::string preset;
  GivenParams params;
  std::chrono::milliseconds timeout{std::chrono::hours(2)};
};

struct JobDifference {
  bool images = true;      ///< write the negative of the absolute error
  bool heat = true;        ///< write the heat map
  bool baseline = true;    ///< also the difference between a variant and the baseline
  double heat_scale = 64;  ///< of 255: the error at the end of the colour bar
};

struct Job {
  std::string name;
  std::filesystem::path file;
  int width = 1024;
  int height = 768;
  int samples = 1;  ///< supersampling per axis, on both sides
  std::vector<JobScene> scenes;
  std::vector<JobVariant> variants;
  std::vector<JobReference> references;
  std::string baseline;           ///< a variant's name, or empty
  std::string primary_reference;  ///< a reference's name, or empty where there is none
  std::vector<std::string> metrics;
  std::vector<Gate> gates;
  JobDifference difference;
  std::vector<std::string> buffers;  ///< written beside each snapshot whose technique has them
};

/// All parameters of a variant without a sweep, and of a reference.
ParamValues variant_params(const JobVariant& variant);
ParamValues reference_params(const JobReference& reference);

}  // namespace lightbench
