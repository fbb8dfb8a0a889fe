#include <cmath>

#include "fuzz_input.h"
#include "scene/mtl_loader.h"

namespace lightbench::fuzz {
namespace {

bool is_finite(const glm::vec3& color) {
  return std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
}

}  // namespace

void fuzz_mtl(std::string_view bytes) {
  static const InputFolder folder;
  ProblemList problems;
  const std::vector<MtlMaterial> materials = load_mtl(folder.write("m.mtl", bytes), problems);
  refuse(problems.all());  // what is left of a file with errors is not used
  for (const MtlMaterial& material : materials) {
    require(is_finite(material.diffuse) && is_finite(material.specular) && is_finite(material.emission),
            "a colour that is not finite");
    require(std::isfinite(material.exponent), "an exponent that is not finite");
  }
}

}  // namespace lightbench::fuzz
