#include <array>

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "renderer/shader_source.h"
#include "renderer/technique.h"
#include "renderer/techniques/ambient.h"
#include "renderer/techniques/caustics.h"
#include "renderer/techniques/direct.h"
#include "renderer/techniques/images.h"
#include "renderer/techniques/isr.h"
#include "renderer/techniques/isr_oracle.h"
#include "renderer/techniques/path_tracer.h"
#include "renderer/techniques/surface_radiance.h"

namespace lightbench {

std::span<const Technique> techniques() {
  static const std::array table{
      direct_technique(),   isr_technique(),     isr_oracle_technique(),  surface_radiance_technique(),
      caustics_technique(), ambient_technique(), path_tracer_technique(), images_technique(),
  };
  return table;
}

const Technique& find_technique(const std::string& name, const std::string& where) {
  std::vector<std::string> names;
  for (const Technique& technique : techniques()) {
    if (technique.name == name) return technique;
    names.push_back(technique.name);
  }
  throw Error("no technique is named '" + name + "'" + did_you_mean(name, names) +
                  "; there are: " + join(names, ", "),
              where);
}

std::vector<std::string> reasons_against(const Technique& technique, const Scene& scene,
                                         const ParamValues& params) {
  std::vector<std::string> reasons;
  if (technique.unsupported) reasons = technique.unsupported(scene, params);
  if (scene.water && !technique.shows_water) reasons.emplace_back("it shows no water");
  return reasons;
}

int technique_bounces(const Technique& technique, const ParamValues& params) {
  return technique.bounces ? technique.bounces(params) : 0;
}

std::string technique_fingerprint(const Technique& technique) {
  Hasher hasher;
  hasher.field("name", technique.name);
  hasher.field("version", std::int64_t{technique.version});
  for (const std::string& shader : technique.shaders) hasher.field(shader, shader_source(shader));
  return hasher.digest();
}

}  // namespace lightbench
