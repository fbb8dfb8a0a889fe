#include "renderer/caustics/volumes.h"

#include <glad/gl.h>

#include "renderer/gl_program.h"

namespace lightbench {
namespace {

void attach_rays(VertexArray& vertices, const Volumes& volumes, const Buffer& corners) {
  vertices.attribute(0, volumes.places, 4);
  vertices.attribute(1, volumes.ways, 2);
  vertices.indices(corners);
}

}  // namespace

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
  attach_rays(vertices, *this, corners);
}

void Volumes::set_uniforms(const Program& program) const {
  program.set("absorption", absorption);
  program.set("map_area", map_area);
  program.set("least_area", least_area);
}

VolumeList::VolumeList(const Volumes& volumes)
    : numbers(buffer_of(std::vector<std::uint32_t>(std::size_t(volumes.triangle_count)))),
      corners(buffer_of(std::vector<glm::uvec3>(std::size_t(volumes.triangle_count)))) {
  attach_rays(vertices, volumes, corners);
  const DrawVolumes nothing;
  command = Buffer(&nothing, sizeof nothing);
}

}  // namespace lightbench
