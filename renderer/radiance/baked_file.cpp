#include "renderer/radiance/baked_file.h"

#include <array>
#include <bit>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "base/error.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little, "entries are copied to and from files as they are");

constexpr std::uint32_t kVersion = 1;

using HeaderBytes = std::array<char, kBakedHeaderBytes>;

class FieldWriter {
 public:
  explicit FieldWriter(HeaderBytes& bytes) : at_(bytes.data()) {}

  template <typename T>
  void put(T value) {
    std::memcpy(at_, &value, sizeof value);
    at_ += sizeof value;
  }

 private:
  char* at_;
};

class FieldReader {
 public:
  FieldReader(const HeaderBytes& bytes, const std::string& where) : at_(bytes.data()), where_(where) {}

  template <typename T>
  T get() {
    T value;
    std::memcpy(&value, at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

  template <typename T>
  int get_between(const char* name, int low, int high) {
    const T value = get<T>();
    if (value < T(low) || value > T(high))
      throw Error(fmt::format("{} is {}, must be {} to {}", name, value, low, high), where_);
    return int(value);
  }

 private:
  const char* at_;
  const std::string& where_;
};

/// "lb-" and the extension, filled up with zero bytes.
std::uint64_t magic_of(std::string_view kind) {
  std::array<char, 8> text{'l', 'b', '-'};
  assert(kind.size() <= text.size() - 3);
  kind.copy(text.data() + 3, text.size() - 3);
  return std::bit_cast<std::uint64_t>(text);
}

HeaderBytes bytes_of(const BakedHeader& header, std::string_view kind) {
  HeaderBytes bytes{};
  FieldWriter fields(bytes);
  fields.put(magic_of(kind));
  fields.put(kVersion);
  fields.put(std::uint32_t(header.width));
  fields.put(std::uint32_t(header.height));
  fields.put(std::uint32_t(header.grid.layers()));
  fields.put(std::uint32_t(header.grid.thetas));
  fields.put(std::uint32_t(header.grid.phis));
  fields.put(std::uint32_t(header.grid.order));
  fields.put(std::uint16_t(header.components));
  fields.put(std::uint16_t(header.bits));
  fields.put(header.scale);
  fields.put(std::uint32_t(header.entries));
  return bytes;
}

BakedHeader parse(const HeaderBytes& bytes, std::string_view kind, const std::string& where) {
  FieldReader fields(bytes, where);
  if (fields.get<std::uint64_t>() != magic_of(kind))
    throw Error(fmt::format("is not a .{} file", kind), where);
  if (const auto version = fields.get<std::uint32_t>(); version != kVersion)
    throw Error(fmt::format("is of version {}, only {} can be read", version, kVersion), where);
  BakedHeader header;
  header.width = fields.get_between<std::uint32_t>("the width", 1, kMaxBakedSize);
  header.height = fields.get_between<std::uint32_t>("the height", 1, kMaxBakedSize);
  const int depth = fields.get_between<std::uint32_t>("the depth", 2, kMaxThetas * kMaxPhis);
  header.grid.thetas = fields.get_between<std::uint32_t>("the number of thetas", 2, kMaxThetas);
  header.grid.phis = fields.get_between<std::uint32_t>("the number of phis", 1, kMaxPhis);
  if (header.grid.layers() != depth)
    throw Error(fmt::format("{} thetas times {} phis are not the depth, {}", header.grid.thetas,
                            header.grid.phis, depth),
                where);
  header.grid.order =
      LayerOrder(fields.get_between<std::uint32_t>("the layer order", 0, int(layer_orders().size()) - 1));
  header.components = fields.get_between<std::uint16_t>("the number of components", 1, 4);
  header.bits = fields.get_between<std::uint16_t>("the bits per component", 8, 32);
  header.scale = fields.get<float>();
  if (!std::isfinite(header.scale) || header.scale <= 0)
    throw Error(fmt::format("the scale is {}, must be a number above 0", header.scale), where);
  header.entries = fields.get<std::uint32_t>();
  return header;
}

std::string system_message() {
  return std::strerror(errno);
}

}  // namespace

std::uint64_t BakedHeader::file_bytes() const {
  return kBakedHeaderBytes + entries * std::uint64_t(components * bits / 8);
}

BakedFile::BakedFile(const fs::path& file, std::string_view kind, const BakedHeader& header,
                     std::span<const std::byte> entries, FileSystem& files)
    : file_(file, files) {
  assert(header.file_bytes() == kBakedHeaderBytes + entries.size());
  if (header.entries > kMaxBakedEntries)
    throw Error(fmt::format("cannot hold {} entries, at most {}", header.entries, kMaxBakedEntries),
                file.string());
  const HeaderBytes bytes = bytes_of(header, kind);
  parse(bytes, kind, file.string());  // so that nothing is written that cannot be read
  file_.write({bytes.data(), bytes.size()});
  file_.write({reinterpret_cast<const char*>(entries.data()), entries.size()});
  file_.finish();
}

BakedReader::BakedReader(const fs::path& file, std::string_view kind) : file_(file) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(file, error);
  if (error) fail("cannot read the file: " + error.message());
  stream_.open(file, std::ios::binary);
  if (!stream_) fail("cannot read the file: " + system_message());
  HeaderBytes bytes{};
  if (size < bytes.size() || !stream_.read(bytes.data(), bytes.size())) fail("ends within its header");
  header_ = parse(bytes, kind, file_.string());
  if (size != header_.file_bytes())
    fail(fmt::format("has {} bytes, but {} by its header", size, header_.file_bytes()));
}

void BakedReader::expect_entries(int components, int bits) const {
  if (header_.components != components || header_.bits != bits)
    fail(fmt::format("holds {} components of {} bits, {} of {} are expected", header_.components,
                     header_.bits, components, bits));
}

void BakedReader::fail(const std::string& what) const {
  throw Error(what, file_.string());
}

void BakedReader::read(std::span<std::byte> bytes) {
  assert(kBakedHeaderBytes + bytes.size() == header_.file_bytes());
  if (!stream_.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size())))
    fail("cannot be read to its end: " + system_message());
}

}  // namespace lightbench
