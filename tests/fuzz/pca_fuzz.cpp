#include <cstdint>

#include "fuzz_input.h"
#include "renderer/radiance/pca_file.h"

namespace lightbench::fuzz {
namespace {

constexpr std::uint64_t kMostValues = 1 << 16;  // times the coefficients is the work of decoding

}  // namespace

/// Principal components with their compressed blocks (RGTC) and corrections.
void fuzz_pca(std::string_view bytes) {
  static const InputFolder folder;
  const PcaStack stack = read_pca(folder.write("object.mtpc", bytes));
  const std::uint64_t values = stack.texels() * std::uint64_t(stack.grid.layers());
  if (values <= kMostValues)
    require(decode_pca(stack).texels.size() == values, "values that are not decoded");
  write_pca(folder.path() / "again.mtpc", stack);
}

}  // namespace lightbench::fuzz
