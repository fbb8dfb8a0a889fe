#include "pipeline/inspect.h"

#include <algorithm>

#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "base/hash.h"
#include "base/input_file.h"
#include "pipeline/concrete.h"
#include "pipeline/snapshot.h"
#include "renderer/radiance/object_bake.h"
#include "renderer/rays.h"
#include "renderer/renderer.h"
#include "renderer/techniques/images.h"
#include "scene/light_points.h"
#include "scene/motion.h"
#include "scene/random_views.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

void inspect_exports(const Job& job, const JobScene& job_scene, Scene& scene, SceneFacts& facts) {
  std::map<std::string, std::unique_ptr<SceneExport>> exports;
  for (const auto& reference : job.references) {
    auto& parts = facts.exports.emplace_back();
    const ReferenceKind& kind = find_reference_kind(reference.kind, "");
    if (!kind.exports()) continue;
    auto& exported = exports[reference.kind];
    if (!exported) {
      exported = kind.make_export(scene);
      facts.kind_warnings[reference.kind] = exported->warnings();
    }
    const ParamValues params = reference_params(reference);
    for (const auto& view : views_of(job_scene)) {
      set_time(scene, view.time);
      parts.push_back(
          exported->key_parts({view, job.width, job.height, job.samples, params, reference.timeout}));
    }
  }
}

void inspect_objects(const Job& job, const Scene& scene, SceneFacts& facts) {
  facts.sizes.resize(job.variants.size());
  for (std::size_t v = 0; v < job.variants.size(); ++v) {
    if (!find_technique(job.variants[v].technique, "").needs_bake) continue;
    facts.sizes[v] = expected_sizes(scene, bake_settings(variant_params(job.variants[v])));
    if (!facts.objects.empty()) continue;
    for (const std::size_t entity : objects_to_bake(scene))
      facts.objects.push_back({int(entity), scene.entities[entity].name, object_file_stem(scene, entity)});
  }
}

}  // namespace

KeyParts file_parts(const Scene& scene) {
  KeyParts parts;
  for (const auto& file : scene.files) parts.emplace_back(file.path.filename().string(), file.hash);
  return parts;
}

SceneFacts inspect_scene(const Job& job, const JobScene& job_scene) {
  SceneFacts facts;
  try {
    Scene scene = load_scene(job_scene.file);
    facts.files = file_parts(scene);
    for (const auto& file : file_paths(scene))
      facts.paths.push_back(std::filesystem::absolute(file).string());
    facts.triangles = triangle_count(scene);
    facts.light_points = light_point_count(scene);
    facts.texture_bytes = texture_bytes(scene);
    facts.moves = moves(scene);
    facts.warnings = scene.warnings;
    facts.credits = scene.credits;
    for (const auto& variant : job.variants)
      facts.unsupported.push_back(
          reasons_against(find_technique(variant.technique, ""), scene, variant_params(variant)));
    inspect_objects(job, scene, facts);
    inspect_exports(job, job_scene, scene, facts);
  } catch (const Error& error) {
    facts = SceneFacts();
    facts.error = error.what();
  }
  return facts;
}

namespace {

/// The picture that an `images` variant shows of a view; one that is not there, or too large to be one, fails
/// when it is read.
KeyParts picture_parts(const JobVariant& variant, const std::string& scene, const std::string& view) {
  if (variant.technique != images_technique().name) return {};
  const std::string file = picture_path(variant_params(variant).text("pattern"), scene, view);
  try {
    return {{"picture", hash_file(file, kLargestPictureFile)}};
  } catch (const Error&) {
    return {{"picture", "missing"}};
  }
}

}  // namespace

PlanFacts inspect(const Job& job, const std::string& gl, const InspectScenes& inspect_scenes) {
  PlanFacts facts;
  facts.gl = gl;
  const auto needs_gl = [](const JobVariant& v) { return find_technique(v.technique, "").needs_gl; };
  if (std::any_of(job.variants.begin(), job.variants.end(), needs_gl))
    facts.renderer = Renderer(parse_gl(gl, "--gl")).description();
  for (const auto& reference : job.references) {
    if (facts.tools.contains(reference.kind) || facts.missing_tools.contains(reference.kind)) continue;
    try {
      facts.tools[reference.kind] = find_reference_kind(reference.kind, "").tool_version();
    } catch (const Error& error) {
      facts.missing_tools[reference.kind] = error.what();
    }
  }
  facts.scenes = inspect_scenes(job);
  for (const auto& scene : job.scenes) {
    auto& pictures = facts.pictures.emplace_back();
    for (const auto& view : views_of(scene)) {
      auto& row = pictures.emplace_back();
      for (const auto& variant : job.variants) row.push_back(picture_parts(variant, scene.name, view.name));
    }
  }
  return facts;
}

std::vector<View> draw_job_views(const JobScene& job_scene, const RandomViewsRequest& request,
                                 double aspect) {
  Scene scene = load_scene(job_scene.file);
  if (job_scene.sequence) set_time(scene, job_scene.sequence->start);
  return draw_views(scene, request, aspect);
}

std::vector<View> draw_views(const Scene& scene, const RandomViewsRequest& request, double aspect) {
  const SceneRays rays(scene);
  RandomViewOptions options;
  options.count = request.count;
  options.seed = request.seed;
  options.fov = glm::radians(float(request.fov));
  options.aspect = float(aspect);
  options.version = request.version;
  return draw_random_views(scene, options, [&rays](const glm::vec3& origin, const glm::vec3& direction) {
    return rays.closest_hit(origin, direction);
  });
}

}  // namespace lightbench
