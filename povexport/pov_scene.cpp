#include "povexport/pov_scene.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "povexport/pov_lights.h"
#include "povexport/pov_materials.h"
#include "povexport/pov_mesh.h"
#include "povexport/pov_water.h"
#include "povexport/pov_writer.h"
#include "scene/motion.h"

namespace lightbench {
namespace {

constexpr const char* kSceneInclude = "scene.inc";

constexpr double kSize = 1024, kSizeWithPhotons = 4;  // of a scene's diagonal, in POV-Ray's units

/// POV-Ray takes nothing for a hit that is nearer to a ray's origin than a fixed length, 0.001: light leaks
/// where things touch in a small scene, and in a large one rays hit the surface that they leave. So every
/// scene is brought to the size at which that length is a millionth of it. A power of two leaves all
/// coordinates exact. Photons, though, are missed on curved and tilted surfaces of large scenes (a fifth of
/// them on a ball in one of this size, a thirtieth at 64), which are found at a few units.
PovSpace pov_space(const Scene& scene) {
  const Bounds bounds = swept_bounds(scene);
  const double diagonal = bounds.diagonal();
  if (!(diagonal > 0) || !std::isfinite(diagonal)) return {bounds, 1};
  return {bounds, std::exp2(std::floor(std::log2((scene.water ? kSizeWithPhotons : kSize) / diagonal)))};
}

/// The rows of POV-Ray's matrix are where the axes and the origin go: the columns of ours. The meshes are
/// scaled already, so that only the origin is left to be.
void write_transform(PovWriter& out, const glm::mat4& m, double scale) {
  if (m == glm::mat4(1)) return;
  out.words(" matrix<");
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) {
      if (column + row > 0) out.words(",");
      out.number(column < 3 ? m[column][row] : float(scale * m[column][row]));
    }
  out.words(">");
}

void write_entity(PovWriter& out, const Entity& entity, const PovSpace& space) {
  out.name("object{M", entity.mesh + 1);
  write_transform(out, entity.transform, space.scale);
  out.words("}\n");
}

std::string mesh_file(int mesh) {
  return pov_file_name("mesh", mesh + 1, "inc");
}

PovWriter scene_include(const Scene& scene, const PovSpace& space, const PovWriter& declarations,
                        const std::vector<bool>& has_mesh) {
  PovWriter out;
  out.words("#declare Clear=texture{pigment{rgbt 1}finish{ambient 0 diffuse 0}}\n");
  out.append(declarations);
  for (std::size_t i = 0; i < has_mesh.size(); ++i)
    if (has_mesh[i])
      out.words("#declare ").name("M", int(i) + 1).words("=\n#include ").file(mesh_file(int(i))).words("\n");
  for (const Entity& entity : scene.entities)
    if (has_mesh[std::size_t(entity.mesh)] && entity.motion.keys.empty()) write_entity(out, entity, space);
  return out;
}

/// max_trace_level: stacked cut-outs turn black at the usual 5. adc_bailout: at the usual 1/255, darker
/// layers of a surface get no indirect light.
void write_global_settings(PovWriter& out, const Scene& scene, const PovSpace& space,
                           const PovOptions& options) {
  out.words("#version 3.7;\nglobal_settings{\nassumed_gamma 1\nmax_trace_level 256\nadc_bailout 0.0001\n");
  if (options.radiosity) {
    out.words("radiosity{\nbrightness ").number(options.brightness);
    out.words("\ncount ").integer(options.count);
    out.words("\nerror_bound ").number(options.error_bound);
    out.words("\nrecursion_limit ").integer(options.recursion_limit);
    out.words("\npretrace_start ").number(options.pretrace_start);
    out.words("\npretrace_end ").number(options.pretrace_end);
    out.words("\n}\n");
  }
  if (scene.water) {
    const glm::vec2 size = scene.water->max - scene.water->min;
    out.words("photons{spacing ")
        .number(options.photon_spacing * space.scale * double(std::max(size.x, size.y)));
    out.words("}\n");
  }
  out.words("}\n");
}

void write_camera(PovWriter& out, const Camera& camera, double aspect, double scale, double parallel_height) {
  const CameraFrame frame = camera_frame(camera);
  const bool parallel = parallel_height > 0;
  const double height = parallel ? scale * parallel_height : 2 * std::tan(double(camera.fov) / 2);
  out.words("camera{\n");
  if (parallel) out.words("orthographic\n");
  out.words("location").vector(scale * glm::dvec3(camera.position));
  out.words("\ndirection").vector(frame.forward);
  out.words("\nright").vector(frame.right).words("*").number(height * aspect);
  out.words("\nup").vector(frame.up).words("*").number(height).words("\n}\n");
}

std::vector<std::string> inexact_features(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const Light& light : scene.lights)
    for (const std::string& warning : pov_light_warnings(light)) warnings.push_back(warning);
  for (const Material& material : scene.materials)
    if (material.reflectance != 1)
      warnings.push_back(
          "material '" + material.name +
          "': POV-Ray cannot scale the indirect light of a surface alone; its reflectance is left out");
  if (scene.near || scene.far)
    warnings.emplace_back("near and far: POV-Ray also draws what lies outside of them");
  if (scene.water)
    warnings.emplace_back(
        "the water: POV-Ray takes every camera to be above it; one below it sees it the other way round");
  return warnings;
}

}  // namespace

PovAssets pov_assets(const Scene& scene) {
  if (triangle_count(scene) == 0)
    throw Error("the scene has no triangles: there is nothing to render", scene.name);
  PovAssets assets;
  PovMaterials materials(scene);
  assets.space = pov_space(scene);
  std::vector<bool> has_mesh(scene.meshes.size());
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const PovWriter mesh = pov_mesh(scene.meshes[i], float(assets.space.scale), materials);
    has_mesh[i] = !mesh.text().empty();
    if (has_mesh[i]) assets.includes[mesh_file(int(i))] = mesh.text();
  }
  assets.includes[kSceneInclude] =
      scene_include(scene, assets.space, materials.declarations(), has_mesh).text();
  assets.images = materials.take_images();
  assets.warnings = inexact_features(scene);
  return assets;
}

std::string pov_view(const Scene& scene, const PovAssets& assets, const Camera& camera, double aspect,
                     const PovOptions& options) {
  PovWriter out;
  write_global_settings(out, scene, assets.space, options);
  // See-through where nothing is hit, so that alpha is the coverage; radiosity still gathers its colour. Who
  // renders the scene puts Background behind the image.
  out.words("#declare Background=").vector(scene.background.color).words(";\n");
  const glm::vec3 sky = scene.background.lights ? scene.background.color : glm::vec3(0);
  out.words("background{rgbt<")
      .number(sky.x)
      .words(",")
      .number(sky.y)
      .words(",")
      .number(sky.z)
      .words(",1>}\n");
  write_camera(out, camera, aspect, assets.space.scale, options.parallel_height);
  for (const Light& light : scene.lights)
    out.append(pov_light(light, assets.space, {options.shadowless, scene.water.has_value()}));
  out.words("#include ").file(kSceneInclude).words("\n");
  if (scene.water) out.append(pov_water(scene, assets.space, options.fresnel));
  for (const Entity& entity : scene.entities)
    if (!entity.motion.keys.empty() && assets.includes.contains(mesh_file(entity.mesh)))
      write_entity(out, entity, assets.space);
  return out.text();
}

}  // namespace lightbench
