#include "fuzz_input.h"
#include "renderer/radiance/radiance_file.h"

namespace lightbench::fuzz {

/// Radiance as it is, of 8 or of 16 bits.
void fuzz_mtex(std::string_view bytes) {
  static const InputFolder folder;
  const auto file = folder.write("object.mtex", bytes);
  const BakedHeader header = read_radiance_header(file);
  const std::size_t texels = header.bits == 16 ? to_bytes(read_half_radiance(file)).texels.size()
                                               : read_byte_radiance(file).texels.size();
  require(texels == header.values(), "another number of texels than the header has");
}

}  // namespace lightbench::fuzz
