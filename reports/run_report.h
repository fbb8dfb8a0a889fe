#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/metric.h"

/// The model of a run that every report is made from; it is what run.json holds (jobs/run.schema.json).
namespace lightbench {

inline constexpr int kRunFormatVersion = 2;

enum class Outcome { ok, failed, skipped };

struct PassSeconds {
  std::string name;
  double seconds = 0;
};

struct ReportCredit {
  std::string piece;
  std::string creator;
  std::string license;
};

struct ReportScene {
  std::string name;
  std::string file;  ///< as the job names it
  std::size_t triangles = 0;
  std::string hash;  ///< of what its files hold
  std::vector<std::string> warnings;
  std::vector<ReportCredit> credits;
};

/// A view that is a frame of a sequence.
struct ReportFrame {
  std::string view;
  double time = 0;  ///< seconds
};

struct ReportSequence {
  std::string scene;
  std::string name;
  std::vector<ReportFrame> frames;  ///< in their order
};

/// A variant or a reference as the job has it.
struct ReportImageSource {
  std::string name;
  std::string kind;                           ///< technique or reference kind
  std::map<std::string, std::string> params;  ///< as text
  int bounces = 0;
  bool offline = false;  ///< a variant that traces paths: with a reference's bounces it is that one's ceiling
  std::string tool;      ///< renderer string, or POV-Ray's version
  bool limited = false;  ///< an offline variant that leaves out light on purpose: no ceiling
  bool external = false;  ///< pictures of another engine: neither their cost nor their bounces are known
};

/// The snapshot of a variant, or a reference image, of one view.
struct ReportImage {
  std::string scene;
  std::string view;
  std::string source;  ///< variant or reference name
  bool is_reference = false;
  Outcome outcome = Outcome::ok;
  std::string error;  ///< of a failed task
  std::string png;    ///< paths relative to the run's folder
  std::string exr;
  std::string pov;                          ///< of a POV-Ray reference
  std::string key;                          ///< hash of all that decides the image
  double seconds = 0;                       ///< wall clock; 0: not known
  double cpu_seconds = 0;                   ///< of all that rendered it; 0: not known
  std::optional<double> noise;              ///< of a reference: estimated mean error, of 255
  std::optional<double> mean_luminance;     ///< of a reference: of its object pixels, linear
  std::map<std::string, double> ray_rates;  ///< rays a second by class of ray, of a path-traced reference
  bool cached = false;                      ///< made by an earlier run
  bool contended = true;                    ///< other tasks ran at the same time
  std::vector<PassSeconds> passes;
  std::vector<std::string> warnings;
  std::map<std::string, std::string> buffers;  ///< buffer name -> file
};

struct ReportScore {
  std::string scene;
  std::string view;
  std::string variant;
  std::string reference;
  Outcome outcome = Outcome::ok;
  std::string error;
  std::map<std::string, MetricValue> metrics;
  std::string difference_png;
  std::string heat_png;
  std::string baseline_difference_png;  ///< variant against baseline; may be empty
  std::vector<std::string> warnings;    ///< e.g. another number of bounces than the reference
};

/// An object whose radiance was baked, or what a codec made of one.
struct ReportObject {
  std::string scene;
  std::string object;                 ///< name of the entity
  std::vector<std::string> variants;  ///< all that draw it
  Outcome outcome = Outcome::ok;
  std::string error;
  double seconds = 0;
  double cpu_seconds = 0;
  bool cached = false;                      ///< made by an earlier run
  bool contended = true;                    ///< other tasks ran at the same time
  std::optional<double> noise;              ///< of a bake: estimated mean error of its indirect light, of 255
  std::map<std::string, double> ray_rates;  ///< of a bake: rays a second by class of ray
  /// Of a bake: width, height, texels, directions. Of a compression: those, raw_bytes, bytes.EXTENSION of
  /// each file, ratio, changed_values, changed, mean_changed_error, error_99, max_error, max_component_error,
  /// colors.
  std::map<std::string, MetricValue> numbers;
};

enum class GateState {
  met,
  not_met,
  within_noise,  ///< met, but by less than the reference is exact: shown as a warning
  not_judged,    ///< nothing, or only a part of what it is about, was measured
};
inline constexpr const char* kGateStateNames[] = {"met", "not met", "within noise", "not judged"};

/// How a gate that holds for each view came out on one of them.
struct ReportGateView {
  std::string scene;
  std::string view;
  std::string variant;  ///< where the gate is about several; else empty
  GateState state = GateState::not_met;
  std::string detail;
};

struct ReportGate {
  std::string text;  ///< as the job wrote it
  GateState state = GateState::not_met;
  std::string detail;  ///< the value, or where and why it failed or was not judged; the worst view first
  std::string
      name{};  ///< without the bounds' numbers, unique in the run: for histories, in which these change
  std::vector<ReportGateView> views{};  ///< of a gate that holds for each view
};

struct RunReport {
  int format = kRunFormatVersion;
  std::string job;
  std::string job_file;
  std::string started;  ///< ISO 8601, UTC
  double seconds = 0;
  int width = 0;
  int height = 0;
  int samples = 1;
  bool partial = false;  ///< gates were judged by the scores that are there, as the user wanted
  std::string baseline;  ///< variant name, may be empty
  std::string primary_reference;
  std::vector<std::string> metric_names;
  std::map<std::string, std::string> tools;  ///< name -> version or fingerprint
  std::vector<ReportScene> scenes;
  std::vector<ReportSequence> sequences;
  std::vector<ReportImageSource> variants;
  std::vector<ReportImageSource> references;
  std::vector<ReportImage> images;
  std::vector<ReportScore> scores;
  std::vector<ReportObject> bakes;
  std::vector<ReportObject> compressions;
  std::vector<ReportGate> gates;
  std::vector<std::string> warnings;
};

/// run.json's text, and back. Undefined values are {"undefined": reason}. `from_json` throws Error with the
/// place.
std::string run_report_to_json(const RunReport& report);
RunReport run_report_from_json(const std::string& text, const std::string& file);

/// Mean over the defined values of a metric for (variant, reference), over all views or those of one scene
/// (empty: all); undefined when there is none. `count` tells how many there were.
struct MeanValue {
  MetricValue mean;
  std::size_t count = 0;
  std::size_t undefined = 0;
};
MeanValue mean_metric(const RunReport& report, const std::string& metric, const std::string& variant,
                      const std::string& reference, const std::string& scene = "");

/// A score's number, or why it has none: also where the task failed or the metric was not computed.
MetricValue metric_of(const ReportScore& score, const std::string& metric);

}  // namespace lightbench
