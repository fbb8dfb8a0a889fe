#include "renderer/caustics/volumes.h"

#include <glad/gl.h>

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
                 double least_texels, const GlTexture* shade_, const OccluderMap* occluders_)
    : ray_count(int(rays.places.size())),
      triangle_count(int(rays.corners.size())),
      places(buffer_of(rays.places)),
      ways(buffer_of(rays.ways)),
      spots(buffer_of(rays.spots)),
      corners(buffer_of(rays.corners)),
      triangles(buffer_of(rays.triangles)),
      absorption(absorption_),
      shade(shade_),
      occluders(occluders_) {
  least_area = float(least_texels * map.box.size.x * map.box.size.z) /
               (float(map.places.width()) * float(map.places.height()));
  vertices.attribute(0, places, 4);
  vertices.attribute(1, ways, 2);
  vertices.attribute(2, spots, 2);
  vertices.indices(corners);
}

ShaderDefines Volumes::defines(ShaderDefines more) const {
  if (shade) more.emplace_back("SHADED");
  if (occluders) more.emplace_back("OCCLUDERS");
  return more;
}

void Volumes::set_uniforms(const Program& program) const {
  if (shade) shade->bind(1);
  if (occluders) occluders->set_uniforms(program);
  program.set("absorption", absorption);
  program.set("least_area", least_area);
}

}  // namespace lightbench
