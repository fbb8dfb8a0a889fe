#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/job.h"
#include "pipeline/references.h"
#include "renderer/radiance/object_size.h"
#include "reports/run_report.h"

namespace lightbench {

enum class TaskKind { bake, compress, snapshot, export_, reference, score };

const std::vector<std::string>& task_kind_names();
std::string to_text(TaskKind kind);

/// What a task takes of the machine while it runs.
struct Resources {
  int cores = 1;
  int gpu = 0;
  int memory_mb = 0;
};

inline constexpr int kNone = -1;

/// One step of a run. The indices point into the concrete job; kNone where a kind has none.
struct Task {
  TaskKind kind = TaskKind::snapshot;
  std::string id;     ///< "snapshot:scene/view/variant", names escaped; unique in the plan
  std::string label;  ///< "scene/view/variant" in plain names, for people and for --only
  std::string key;    ///< hash of `key_parts`: with an equal key the outputs are equal
  KeyParts key_parts;
  std::vector<std::string>
      outputs;  ///< relative to the run's folder; an export's shared files are known when done
  std::vector<std::size_t> deps;  ///< earlier tasks of the plan
  int scene = kNone;
  int view = kNone;  ///< kNone: an export's files that all views share
  int variant = kNone;
  int reference = kNone;
  int object = kNone;  ///< of a bake and its compression: an entity of the scene
  Resources resources;
  double expected_seconds = 0;
  double timeout_seconds = 0;
  std::string group;    ///< tasks of one group share what a worker loads
  std::string refused;  ///< why it cannot be done at all, known before any work; else empty
};

/// A run as a graph of tasks; dependencies stand before those that need them.
struct Plan {
  Job job;                                ///< concrete
  std::filesystem::path out;              ///< the run's folder, absolute
  std::string gl;                         ///< OpenGL back end
  std::vector<std::string> scene_hashes;  ///< of all that each scene's files hold
  std::vector<Task> tasks;
};

/// An entity whose radiance is baked.
struct ObjectFacts {
  int entity = 0;
  std::string name;
  std::string file_stem;  ///< of its files in a folder of baked objects
};

/// What planning needs to know of a scene and its files.
struct SceneFacts {
  std::string error;  ///< why it cannot be used; then the rest is empty
  std::size_t triangles = 0;
  std::size_t texture_bytes = 0;  ///< that its textures take in memory
  std::size_t light_points = 0;   ///< each has a shadow map
  bool moves = false;             ///< whether its pictures depend on the view's time
  std::vector<std::string> warnings;
  std::vector<Credit> credits;
  KeyParts files;                                     ///< name and hash of everything that was read
  std::vector<std::string> paths;                     ///< of these files, absolute
  std::vector<std::vector<std::string>> unsupported;  ///< [variant]: why its technique cannot show it
  std::vector<ObjectFacts> objects;                   ///< where a variant needs a bake
  std::vector<std::vector<ObjectSize>> sizes;         ///< [variant][object]: what is baked, about; or empty
  std::vector<std::vector<KeyParts>> exports;  ///< [reference][view]; no views where nothing is exported
  std::map<std::string, std::vector<std::string>> kind_warnings;  ///< by reference kind
};

/// Everything from outside that a plan depends on.
struct PlanFacts {
  std::vector<SceneFacts> scenes;                    ///< one for each scene of the job
  std::string gl;                                    ///< back end's name
  std::string renderer;                              ///< its description
  std::map<std::string, std::string> tools;          ///< reference kind -> version
  std::map<std::string, std::string> missing_tools;  ///< reference kind -> why it cannot be run
  std::vector<std::vector<std::vector<KeyParts>>>
      pictures;  ///< [scene][view][variant]: files that a variant reads
};

/// The task graph of a concrete job. Pure: equal input gives an equal plan.
Plan make_plan(const Job& job, const PlanFacts& facts, const std::filesystem::path& out);

/// The folder of a view's files, relative to the run's folder.
std::string view_folder(const Job& job, int scene, int view);
/// Files of a snapshot or reference, without extension.
std::string image_stem(const Job& job, int scene, int view, const std::string& source);
/// Files of a score, without extension.
std::string score_stem(const Job& job, int scene, int view, const std::string& variant,
                       const std::string& other);
/// A named buffer's files, without extension.
std::string buffer_stem(const Job& job, int scene, int view, const std::string& variant,
                        const std::string& buffer);
/// The folder of a scene's baked objects, for variants that bake alike; and of what a codec makes of them,
/// which is the same where it draws them as they are.
std::string baked_folder(const Job& job, int scene, const JobVariant& variant);
std::string compressed_folder(const Job& job, int scene, const JobVariant& variant);
/// The folder of a scene's files for a reference kind.
std::string shared_export_folder(const Job& job, int scene, const std::string& kind);
/// The baseline's buffer that ambient light is fitted with; empty where no metric of the job needs it, or its
/// technique has none.
std::string baseline_albedo(const Job& job);
/// The buffers of the job that this variant's technique has, and of the baseline those that metrics need.
std::vector<std::string> variant_buffers(const Job& job, const JobVariant& variant);

std::string key_of(const KeyParts& parts);

}  // namespace lightbench
