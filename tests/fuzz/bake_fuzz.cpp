#include "fuzz_input.h"
#include "pipeline/bake_folder.h"

namespace lightbench::fuzz {

/// The bake.json of a folder of baked objects.
void fuzz_bake(std::string_view bytes) {
  static const InputFolder folder;
  folder.write("bake.json", bytes);
  const BakeFolder bake = read_bake_folder(folder.path());
  write_bake_folder(folder.path() / "again", bake);
  require(read_bake_folder(folder.path() / "again").params == bake.params,
          "parameters that read back as others");
}

}  // namespace lightbench::fuzz
