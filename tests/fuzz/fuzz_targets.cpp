#include "fuzz_targets.h"

#include <algorithm>

#include "base/error.h"

namespace lightbench::fuzz {

void fuzz_bake(std::string_view bytes);
void fuzz_camera(std::string_view bytes);
void fuzz_image(std::string_view bytes);
void fuzz_job(std::string_view bytes);
void fuzz_json(std::string_view bytes);
void fuzz_ledger(std::string_view bytes);
void fuzz_mtex(std::string_view bytes);
void fuzz_mtl(std::string_view bytes);
void fuzz_obj(std::string_view bytes);
void fuzz_options(std::string_view bytes);
void fuzz_pca(std::string_view bytes);
void fuzz_piecewise(std::string_view bytes);
void fuzz_plan(std::string_view bytes);
void fuzz_run(std::string_view bytes);
void fuzz_scene(std::string_view bytes);

std::span<const FuzzTarget> fuzz_targets() {
  static const FuzzTarget table[] = {
      {"bake", fuzz_bake, "json"},   {"camera", fuzz_camera, "json"},
      {"image", fuzz_image, "-"},    {"job", fuzz_job, "json"},
      {"json", fuzz_json, "json"},   {"ledger", fuzz_ledger, "json"},
      {"mtex", fuzz_mtex, "baked"},  {"mtl", fuzz_mtl, "obj"},
      {"obj", fuzz_obj, "obj"},      {"options", fuzz_options, "json"},
      {"pca", fuzz_pca, "baked"},    {"piecewise", fuzz_piecewise, "baked"},
      {"plan", fuzz_plan, "json"},   {"run", fuzz_run, "json"},
      {"scene", fuzz_scene, "json"},
  };
  return table;
}

const FuzzTarget& find_fuzz_target(const std::string& name) {
  const auto targets = fuzz_targets();
  const auto found = std::ranges::find(targets, name, &FuzzTarget::name);
  if (found == targets.end()) throw Error("there is no fuzz target '" + name + "'", "--target");
  return *found;
}

bool is_read(const FuzzTarget& target, std::string_view bytes) {
  try {
    target.read(bytes);
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace lightbench::fuzz
