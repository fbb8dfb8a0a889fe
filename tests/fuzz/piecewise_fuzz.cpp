#include <algorithm>
#include <cstdint>

#include "fuzz_input.h"
#include "renderer/radiance/piecewise_file.h"

namespace lightbench::fuzz {
namespace {

constexpr std::uint64_t kMostValues =
    1 << 20;  // a small file may stand for many values, which take long to decode

}  // namespace

/// The four files of an object, one after another: .mtnc, .mti, .mtm and .mtsp. Each starts at its "lb-mt".
void fuzz_piecewise(std::string_view bytes) {
  static const InputFolder folder;
  for (const char* extension : {"mtnc", "mti", "mtm", "mtsp"}) {
    const std::size_t end = std::min(bytes.find("lb-mt", 1), bytes.size());
    folder.write(std::string("object.") + extension, bytes.substr(0, end));
    bytes.remove_prefix(end);
  }
  const PiecewiseStack stack = read_piecewise(folder.path() / "object");
  const auto values = std::uint64_t(stack.texels()) * std::uint64_t(stack.grid.layers());
  if (values <= kMostValues)
    require(decode_piecewise(stack).texels.size() == values, "values that are not decoded");
}

}  // namespace lightbench::fuzz
