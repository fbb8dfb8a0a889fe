#include "renderer/radiance/radiance_file.h"

#include <cassert>

#include <fmt/format.h>

namespace lightbench {
namespace fs = std::filesystem;
namespace {

constexpr const char* kKind = "mtex";

template <typename Component>
void write(const fs::path& file, const RadianceStack<Component>& stack) {
  static_assert(sizeof(stack.texels[0]) == 3 * sizeof(Component));
  const BakedHeader header{stack.width, stack.height,          stack.grid,         stack.scale,
                           3,           8 * sizeof(Component), stack.texels.size()};
  assert(header.entries == header.values());
  BakedFile(file, kKind, header, std::as_bytes(std::span(stack.texels))).commit();
}

BakedReader open(const fs::path& file) {
  BakedReader reader(file, kKind);
  const BakedHeader& header = reader.header();
  reader.expect_entries(3, header.bits == 16 ? 16 : 8);
  if (header.entries != header.values())
    reader.fail(
        fmt::format("holds {} texels, not width * height * depth = {}", header.entries, header.values()));
  return reader;
}

template <typename Component>
RadianceStack<Component> read(const fs::path& file) {
  BakedReader reader = open(file);
  reader.expect_entries(3, 8 * sizeof(Component));
  const BakedHeader& header = reader.header();
  using Entry = std::array<Component, 3>;
  return {header.width, header.height, header.grid, header.scale,
          reader.read<Entry, ZeroedAllocator<Entry>>()};
}

}  // namespace

void write_radiance(const fs::path& file, const HalfStack& stack) {
  write(file, stack);
}

void write_radiance(const fs::path& file, const ByteStack& stack) {
  write(file, stack);
}

BakedHeader read_radiance_header(const fs::path& file) {
  return open(file).header();
}

HalfStack read_half_radiance(const fs::path& file) {
  return read<std::uint16_t>(file);
}

ByteStack read_byte_radiance(const fs::path& file) {
  return read<std::uint8_t>(file);
}

}  // namespace lightbench
