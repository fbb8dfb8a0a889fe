#include "fuzz_input.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "base/error.h"

namespace lightbench::fuzz {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

std::filesystem::path InputFolder::write(const std::string& name, std::string_view bytes) const {
  const std::filesystem::path file = path() / name;
  std::filesystem::remove(file);  // some file systems wait when a file is emptied and written anew
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), std::streamsize(bytes.size())).flush();
  require(bool(stream), "cannot write " + file.string());
  return file;
}

void refuse(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems)
    require(!problem.what.empty() && !problem.where.empty(), "a problem without a text or a place");
  for (const Problem& problem : problems)
    if (problem.severity == Problem::Severity::error) throw Error(problem.what, problem.where);
}

void require_sound(const Mesh& mesh, std::size_t materials) {
  const std::size_t vertices = mesh.positions.size();
  require(mesh.normals.size() == vertices, "not one normal for each vertex");
  require(mesh.uvs.empty() || mesh.uvs.size() == vertices, "not one uv for each vertex");
  require(mesh.colors.empty() || mesh.colors.size() == vertices, "not one colour for each vertex");
  for (const glm::uvec3& t : mesh.triangles)
    require(std::max({t.x, t.y, t.z}) < vertices, "a triangle of a vertex that is not there");
  for (const glm::vec3& p : mesh.positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "a position that is not finite");
  for (const glm::vec3& n : mesh.normals)
    require(std::abs(n.x * n.x + n.y * n.y + n.z * n.z - 1) < 1e-4f, "a normal that is not of length 1");
  std::size_t covered = 0;
  for (const MeshPart& part : mesh.parts) {
    require(std::size_t(part.material) < materials, "a part of a material that is not there");
    require(part.first_triangle == covered, "parts that do not follow one another");
    covered += part.triangle_count;
  }
  require(covered == mesh.triangles.size(), "parts that do not cover the triangles");
}

}  // namespace lightbench::fuzz
