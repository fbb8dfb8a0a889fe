#include "renderer/radiance/pca_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied to and from files as they are");

constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMaxSize = 16384;  // the largest textures OpenGL draws from
constexpr std::uint32_t kMaxCoefficients = 1024;

/// As it is in the file.
struct Header {
  std::array<char, 8> magic{'l', 'b', '-', 'm', 't', 'p', 'c'};
  std::uint32_t version = kVersion;
  std::uint32_t width, height;
  std::uint32_t thetas, phis, order;
  std::uint32_t matte;
  float radiance_scale;
  float mean_offset, mean_scale;
  std::uint32_t wide, narrow, compressed;
  std::uint32_t correction_step, corrections;
  std::uint32_t reserved = 0;
};
static_assert(sizeof(Header) == 72 && std::is_trivially_copyable_v<Header>);

Header header_of(const PcaStack& stack) {
  Header header{};
  header.width = std::uint32_t(stack.width), header.height = std::uint32_t(stack.height);
  header.thetas = std::uint32_t(stack.grid.thetas), header.phis = std::uint32_t(stack.grid.phis);
  header.order = std::uint32_t(stack.grid.order);
  header.matte = stack.matte ? 1 : 0;
  header.radiance_scale = stack.radiance_scale;
  header.mean_offset = stack.mean_offset, header.mean_scale = stack.mean_scale;
  header.wide = std::uint32_t(stack.wide_coefficients());
  header.narrow = std::uint32_t(stack.narrow_coefficients());
  header.compressed = std::uint32_t(stack.coefficients()) - header.wide - header.narrow;
  header.correction_step = std::uint32_t(stack.correction_step);
  header.corrections = std::uint32_t(stack.corrections.size());
  return header;
}

/// Calls `handle(numbers, count)` for each array of a stack in the file's order, with how many the header
/// asks for. The stack has its size already.
template <typename Stack, typename Handle>
void for_arrays(Stack& stack, const Header& header, const Handle& handle) {
  const std::uint64_t coefficients = std::uint64_t(header.wide) + header.narrow + header.compressed;
  const std::uint64_t directions = stack.directions(), blocks = stack.block_count();
  handle(stack.offset, coefficients);
  handle(stack.scale, coefficients);
  handle(stack.mean, 3 * directions);
  handle(stack.basis, 12 * directions * ((coefficients + 3) / 4));
  handle(stack.wide, header.wide * stack.texels());
  handle(stack.narrow, header.narrow * stack.texels());
  handle(stack.blocks, header.compressed * blocks);
  handle(stack.first_correction, header.correction_step > 0 ? blocks + 1 : 0);
  handle(stack.corrections, std::uint64_t(header.corrections));
}

class Checks {
 public:
  explicit Checks(std::string where) : where_(std::move(where)) {}

  [[noreturn]] void fail(const std::string& what) const { throw Error(what, where_); }
  void between(const char* name, std::uint32_t value, std::uint32_t low, std::uint32_t high) const {
    if (value < low || value > high) fail(fmt::format("{} is {}, must be {} to {}", name, value, low, high));
  }
  void multiple(const char* name, std::uint32_t value, std::uint32_t of) const {
    if (value % of != 0) fail(fmt::format("{} is {}, must be a multiple of {}", name, value, of));
  }
  void finite(const char* name, float value) const {
    if (!std::isfinite(value)) fail(fmt::format("{} is {}, must be finite", name, value));
  }

 private:
  std::string where_;
};

void check(const Header& header, const Checks& checks) {
  if (header.magic != Header{}.magic) checks.fail("is not a .mtpc file");
  if (header.version != kVersion)
    checks.fail(fmt::format("is of version {}, only {} can be read", header.version, kVersion));
  checks.between("the width", header.width, 1, kMaxSize);
  checks.between("the height", header.height, 1, kMaxSize);
  checks.between("the number of thetas", header.thetas, 2, kMaxThetas);
  checks.between("the number of phis", header.phis, 1, kMaxPhis);
  checks.between("the layer order", header.order, 0, std::uint32_t(layer_orders().size()) - 1);
  checks.between("the mark of matte objects", header.matte, 0, 1);
  checks.finite("the scale of radiance", header.radiance_scale);
  if (header.radiance_scale <= 0) checks.fail("the scale of radiance is not above 0");
  checks.finite("the mean's offset", header.mean_offset);
  checks.finite("the mean's scale", header.mean_scale);
  for (const std::uint32_t count : {header.wide, header.narrow, header.compressed})
    checks.between("a number of coefficients", count, 0, kMaxCoefficients);
  checks.multiple("the number of 16-bit coefficients", header.wide, 4);
  checks.multiple("the number of 8-bit coefficients", header.narrow, 4);
  checks.multiple("the number of compressed coefficients", header.compressed, 2);
  checks.between("the step of corrections", header.correction_step, 0, 255);
  if (header.correction_step == 0 && header.corrections > 0) checks.fail("has corrections without a step");
  checks.between("a field that is reserved", header.reserved, 0, 0);
}

PcaStack empty_stack(const Header& header) {
  PcaStack stack{.width = int(header.width),
                 .height = int(header.height),
                 .grid = {int(header.thetas), int(header.phis), LayerOrder(header.order)},
                 .radiance_scale = header.radiance_scale,
                 .matte = header.matte == 1};
  stack.mean_offset = header.mean_offset, stack.mean_scale = header.mean_scale;
  stack.correction_step = int(header.correction_step);
  return stack;
}

void check_length(std::uint64_t length, const Header& header, const PcaStack& stack, const Checks& checks) {
  std::uint64_t expected = sizeof(Header);
  for_arrays(stack, header,
             [&](const auto& numbers, std::uint64_t count) { expected += count * sizeof(numbers[0]); });
  if (length != expected) checks.fail(fmt::format("has {} bytes, its header asks for {}", length, expected));
}

void check_block(std::span<const std::uint32_t> corrections, std::uint32_t keys, const Checks& checks) {
  std::uint32_t last = 0;
  for (const std::uint32_t packed : corrections) {
    const std::uint32_t key = unpack_correction(packed).key;
    if (key < last) checks.fail("the corrections of a block do not rise");
    if (key >= keys) checks.fail("has a correction for a layer that is not there");
    last = key;
  }
}

void check_contents(const PcaStack& stack, const Checks& checks) {
  for (const std::vector<float>* const table : {&stack.offset, &stack.scale})
    for (const float number : *table) checks.finite("a coefficient's offset or scale", number);
  if (stack.correction_step == 0) return;
  const std::vector<std::uint32_t>& first = stack.first_correction;
  if (first.front() != 0 || first.back() != stack.corrections.size() || !std::ranges::is_sorted(first))
    checks.fail("the blocks' first corrections do not rise from 0 to the number of all");
  for (std::size_t block = 0; block + 1 < first.size(); ++block)
    check_block(std::span(stack.corrections).subspan(first[block], first[block + 1] - first[block]),
                correction_key(stack.grid.layers(), 0), checks);
}

}  // namespace

void write_pca(const fs::path& file, const PcaStack& stack) {
  const Header header = header_of(stack);
  const Checks checks(file.string());
  check(header, checks);  // so that nothing is written that cannot be read
  std::string bytes(sizeof header, '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  for_arrays(stack, header, [&](const auto& numbers, std::uint64_t) {
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(numbers[0]));
  });
  check_length(bytes.size(), header, stack, checks);
  write_file_atomic(file, bytes);
}

PcaStack read_pca(const fs::path& file) {
  const Checks checks(file.string());
  const std::string bytes = read_file(file);
  Header header;
  if (bytes.size() < sizeof header) checks.fail("is too short for a .mtpc file");
  std::memcpy(&header, bytes.data(), sizeof header);
  check(header, checks);
  PcaStack stack = empty_stack(header);
  check_length(bytes.size(), header, stack, checks);
  const char* at = bytes.data() + sizeof header;
  for_arrays(stack, header, [&](auto& numbers, std::uint64_t count) {
    numbers.resize(count);
    std::copy_n(at, count * sizeof(numbers[0]), reinterpret_cast<char*>(numbers.data()));
    at += count * sizeof(numbers[0]);
  });
  check_contents(stack, checks);
  return stack;
}

}  // namespace lightbench
