#include "pipeline/caustics_study.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/files.h"
#include "base/image_io.h"
#include "povexport/pov_scene.h"
#include "povexport/povray.h"
#include "renderer/caustics/caustics_maps.h"
#include "renderer/caustics/light_tracer.h"
#include "renderer/caustics/receiver_texels.h"
#include "renderer/caustics/water_light.h"
#include "reports/escape.h"

namespace lightbench {
namespace {

std::string number_or(const std::optional<double>& value, const char* otherwise) {
  return value ? fmt::format("{:.3f}", *value) : otherwise;
}

double whole_flux(const FluxField& field, const ReceiverBox& box) {
  double sum = 0;
  for (const double value : field.values) sum += value;
  return sum * box.size.x * box.size.z / double(field.values.size());
}

/// What a camera with parallel rays sees of `extent`, across and up, by POV-Ray.
Image parallel_picture(const Scene& scene, const Camera& camera, const glm::dvec2& extent, int pixels,
                       double photon_spacing) {
  const PovAssets assets = pov_assets(scene);
  const TemporaryFolder folder;
  for (const auto& [name, text] : assets.includes) write_file_atomic(folder.path() / name, text);
  for (const auto& [name, image] : assets.images) write_png(folder.path() / name, pov_image(scene, image));
  PovOptions options;
  options.radiosity = false;
  options.photon_spacing = photon_spacing;
  options.parallel_height = extent.y;
  PovrayRun run;
  run.program = find_povray();
  run.library = folder.path();
  run.scene_file = folder.path() / "view.pov";
  run.width = run.height = pixels;
  write_file_atomic(run.scene_file, pov_view(scene, assets, camera, extent.x / extent.y, options));
  return run_povray(run).image;
}

/// Photons that POV-Ray lands on a receiver, for each unit of the map's area: its picture along the axis,
/// from below the water, a pixel for each texel, over the colour and the cosine of what is there.
FluxField povray_flux(const Scene& scene, const ReceiverBox& box, const std::vector<ReceiverTexel>& texels,
                      int size, double photon_spacing) {
  Camera camera;
  camera.position =
      glm::vec3(box.center + (0.5 * box.size.y + 1e-3 * std::max(box.size.x, box.size.z)) * box.v);
  camera.look_at = glm::vec3(box.center);
  camera.up = glm::vec3(box.w);
  const Image picture = parallel_picture(scene, camera, {box.size.x, box.size.z}, size, photon_spacing);
  FluxField field{size, {}, {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const ReceiverTexel& texel = texels[std::size_t(y) * std::size_t(size) + std::size_t(x)];
      const double cosine = glm::dot(glm::dvec3(texel.face), box.v), albedo = double(texel.albedo.r);
      // Where light grazes, photons are few and what they are divided by is small.
      constexpr double kLeastCosine = 0.1;
      const bool counts = texel.own && cosine > kLeastCosine && albedo > 0;
      field.counts.push_back(counts);
      // The camera looks down on the map: w goes up, and u to the left.
      const double shown = double(picture.pixel(size - 1 - x, size - 1 - y)[0]);
      field.values.push_back(counts ? shown / (cosine * albedo) : 0);
    }
  return field;
}

/// With the triangles' own normals: POV-Ray looks for photons near the plane of the normal, and a smooth one
/// misses those on the triangle.
Mesh faceted(const Mesh& mesh) {
  Mesh result = mesh;
  result.positions.clear();
  result.normals.clear();
  result.uvs.clear();
  result.colors.clear();
  result.triangles.clear();
  for (const glm::uvec3& t : mesh.triangles) {
    const auto first = std::uint32_t(result.positions.size());
    const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    const glm::vec3 across = glm::cross(b - a, c - a);
    const float size = glm::length(across);
    for (int corner = 0; corner < 3; ++corner) {
      result.positions.push_back(mesh.positions[t[corner]]);
      result.normals.push_back(size > 0 ? across / size : glm::vec3(0, 1, 0));
      if (!mesh.uvs.empty()) result.uvs.push_back(mesh.uvs[t[corner]]);
      if (!mesh.colors.empty()) result.colors.push_back(mesh.colors[t[corner]]);
    }
    result.triangles.emplace_back(first, first + 1, first + 2);
  }
  return result;
}

class Study {
 public:
  Study(const Scene& scene, const CausticsStudyOptions& options,
        const std::function<void(const std::string&)>& progress)
      : scene_(scene), options_(options), progress_(progress), gl_(scene, options.backend), paths_(scene) {}

  std::vector<ReceiverFigures> of_light(const Light& light) {
    LightTraceOptions trace;
    trace.rays = options_.rays;
    trace.map_size = options_.maps.size;
    trace.threads = options_.threads;
    progress_(fmt::format("{}: rays of {}", scene_.name, light.name));
    const LightTrace traced = trace_light(scene_, light, trace);
    std::vector<ReceiverFigures> figures;
    for (std::size_t entity = 0; entity < scene_.entities.size(); ++entity)
      if (!entity_bounds(scene_, entity).empty()) figures.push_back(of_receiver(light, entity, traced));
    return figures;
  }

 private:
  ReceiverFigures of_receiver(const Light& light, std::size_t entity, const LightTrace& traced) {
    const FluxMap& map = traced.maps[entity];
    const std::vector<ReceiverTexel> texels = receiver_texels(paths_, map.box, entity, map.size);
    FluxField truth = flux_field(map);
    for (std::size_t i = 0; i < texels.size(); ++i) truth.counts[i] = texels[i].own;
    const double flat =
        glm::length(glm::dvec3(incidence_at(light, map.box.center).irradiance)) / std::sqrt(3.0);
    const double most = options_.most * std::max(flat, 1e-30), sent = std::max(traced.sent.r, 1e-30);
    ReceiverFigures figures;
    figures.receiver = scene_.entities[entity].name;
    figures.light = light.name;
    figures.texels = std::size_t(std::count(truth.counts.begin(), truth.counts.end(), true));
    Image first;
    for (const CausticsMethodRow& method : chosen_caustics_methods(options_.methods)) {
      progress_(fmt::format("{}: {}, {}", scene_.name, figures.receiver, method.name));
      const CausticsMap drawn = gl_.draw(entity, light, method_params(method, options_.maps));
      const FluxField field = flux_field(drawn.flux);
      if (first.data.empty()) {
        first = drawn.flux;
        figures.lit = drawn.lit;
        figures.drawn = drawn.drawn;
        figures.sideways = drawn.sideways;
        figures.raised = drawn.raised;
        figures.planes = drawn.used_planes();
      }
      figures.methods.push_back({method.name, compare_flux(field, truth, most),
                                 differing_texels(drawn.flux, first), drawn.texture_bytes,
                                 whole_flux(field, drawn.box) / sent});
    }
    figures.methods.push_back(
        {"rays", compare_flux(truth, truth, most), 0, 0, whole_flux(truth, map.box) / sent});
    if (options_.povray) {
      progress_(fmt::format("{}: {}, POV-Ray", scene_.name, figures.receiver));
      Scene alone = scene_;
      alone.lights = {light};
      alone.water->ambient = glm::vec3(0);
      for (Mesh& mesh : alone.meshes) mesh = faceted(mesh);
      const FluxField photons = povray_flux(alone, map.box, texels, map.size, options_.photon_spacing);
      figures.methods.push_back({"POV-Ray's photons", compare_flux(photons, truth, most), 0, 0, 0});
    }
    return figures;
  }

  const Scene& scene_;
  const CausticsStudyOptions& options_;
  const std::function<void(const std::string&)>& progress_;
  CausticsMaps gl_;
  PathScene paths_;
};

}  // namespace

std::vector<ReceiverFigures> study_caustics(const Scene& scene, const CausticsStudyOptions& options,
                                            const std::function<void(const std::string&)>& progress) {
  require_lit_water(scene);
  Study study(scene, options, progress);
  std::vector<ReceiverFigures> figures;
  for (const Light& light : scene.lights)
    for (ReceiverFigures& of_receiver : study.of_light(light)) figures.push_back(std::move(of_receiver));
  return figures;
}

std::string caustics_tables(const std::vector<std::pair<std::string, std::vector<ReceiverFigures>>>& scenes,
                            int slices) {
  std::string text = fmt::format(
      "| scene | receiver | light | texels | triangles lit | drawn | sideways | planes of {} | raised |\n"
      "| :-- | :-- | :-- | --: | --: | --: | --: | --: | --: |\n",
      slices + 1);
  for (const auto& [scene, receivers] : scenes)
    for (const ReceiverFigures& f : receivers)
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", escape_markdown(scene),
                          escape_markdown(f.receiver), escape_markdown(f.light), f.texels, f.lit, f.drawn,
                          f.sideways, f.planes, f.raised);
  text +=
      "\n| scene | receiver | light | method | correlation | energy | of what enters | texels that differ | "
      "MB |\n"
      "| :-- | :-- | :-- | :-- | --: | --: | --: | --: | --: |\n";
  for (const auto& [scene, receivers] : scenes)
    for (const ReceiverFigures& f : receivers)
      for (const MethodFigures& m : f.methods)
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", escape_markdown(scene),
                            escape_markdown(f.receiver), escape_markdown(f.light), m.method,
                            number_or(m.likeness.correlation, "-"), number_or(m.likeness.energy, "no light"),
                            m.landed > 0 ? fmt::format("{:.4f}", m.landed) : "-",
                            m.texture_bytes > 0 ? std::to_string(m.differing) : "-",
                            m.texture_bytes > 0 ? fmt::format("{:.1f}", double(m.texture_bytes) / 1e6) : "-");
  return text;
}

}  // namespace lightbench
