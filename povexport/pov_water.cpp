#include "povexport/pov_water.h"

#include "scene/water.h"

namespace lightbench {

PovWriter pov_water(const Scene& scene, const PovSpace& space, bool fresnel) {
  const Water& water = *scene.water;
  const Mesh mesh = water_mesh(water, scene.time);
  PovWriter out;
  out.words("mesh2{\nvertex_vectors{").integer(static_cast<long long>(mesh.positions.size())).words("\n");
  for (const glm::vec3& p : mesh.positions) out.vector(space.scale * glm::dvec3(p)).words("\n");
  out.words("}\nnormal_vectors{").integer(static_cast<long long>(mesh.normals.size())).words("\n");
  for (const glm::vec3& n : mesh.normals) out.vector(n).words("\n");
  out.words("}\nface_indices{").integer(static_cast<long long>(mesh.triangles.size())).words("\n");
  for (const glm::uvec3& t : mesh.triangles) out.triple(t).words("\n");
  out.words("}\n");
  out.words(fresnel
                ? PovWriter::Words("texture{pigment{rgbt 1}finish{ambient 0 diffuse 0 reflection{0 1 fresnel}"
                                   "conserve_energy}}\n")
                : PovWriter::Words("texture{Clear}\n"));
  out.words("interior{ior ").number(water.ior);
  // Not fade_distance: that counts at the way out of a body alone, and what stands in the water is met
  // before.
  if (water.absorption != glm::vec3(0))
    out.words(" media{absorption rgb").vector(glm::dvec3(water.absorption) / space.scale).words("}");
  out.words("}\nphotons{target refraction on reflection off collect off}\nhollow\n}\n");
  return out;
}

}  // namespace lightbench
