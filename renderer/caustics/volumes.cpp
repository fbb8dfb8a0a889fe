#include "renderer/caustics/volumes.h"

#include <glad/gl.h>

#include "renderer/gl_program.h"

namespace lightbench {

void set_adding_state() {
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

Volumes::Volumes(const MapRays& rays, const ReceiverMap& map, const glm::vec3& absorption_,
                 double least_texels)
    : ray_count(int(rays.places.size())),
      triangle_count(int(rays.corners.size())),
      places(buffer_of(rays.places)),
      ways(buffer_of(rays.ways)),
      corners(buffer_of(rays.corners)),
      triangles(buffer_of(rays.triangles)),
      absorption(absorption_),
      map_area(float(map.box.size.x * map.box.size.z)) {
  least_area = float(least_texels) * map_area / (float(map.places.width()) * float(map.places.height()));
  vertices.attribute(0, places, 4);
  vertices.attribute(1, ways, 2);
  vertices.indices(corners);
}

void Volumes::set_uniforms(const Program& program) const {
  program.set("absorption", absorption);
  program.set("map_area", map_area);
  program.set("least_area", least_area);
}

}  // namespace lightbench
