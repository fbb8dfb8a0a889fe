#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/atomic_file.h"
#include "renderer/radiance/direction_grid.h"

/// What the files of a baked object have in common: a header of kBakedHeaderBytes, then entries of one size,
/// all little-endian (docs/formats.md has the tables).
namespace lightbench {

inline constexpr std::size_t kBakedHeaderBytes = 48;
inline constexpr std::uint64_t kMaxBakedEntries = 0xffffffff;
inline constexpr int kMaxBakedSize = 16384;  ///< width and height: the largest textures OpenGL draws from

struct BakedHeader {
  int width = 0;   ///< texels, 1 to kMaxBakedSize
  int height = 0;  ///< texels, 1 to kMaxBakedSize
  DirectionGrid grid;
  float scale = 1;            ///< the radiance that stands for 1; finite and above 0
  int components = 1;         ///< of an entry
  int bits = 8;               ///< of a component
  std::uint64_t entries = 0;  ///< up to kMaxBakedEntries
  std::uint64_t texels() const { return std::uint64_t(width) * std::uint64_t(height); }
  std::uint64_t values() const { return texels() * std::uint64_t(grid.layers()); }
  std::uint64_t file_bytes() const;
};

/// A file as it will be, complete on the disk but not yet under its name: several can be written before any
/// of them takes its place. `kind` is the extension, without a dot. Throws Error where the disk is full or
/// the header's numbers are out of range; then nothing stays behind.
class BakedFile {
 public:
  BakedFile(const std::filesystem::path& file, std::string_view kind, const BakedHeader& header,
            std::span<const std::byte> entries, FileSystem& files = machine_files());
  void commit() { file_.commit(); }

 private:
  AtomicFile file_;
};

/// Opens a file and checks its header, and that the file is as long as the header says, before anything is
/// allocated. Throws Error with the file's name.
class BakedReader {
 public:
  BakedReader(const std::filesystem::path& file, std::string_view kind);

  const BakedHeader& header() const { return header_; }
  /// Throws Error unless entries are of that shape.
  void expect_entries(int components, int bits) const;
  /// All entries, once. `Entry` is as large as they are.
  template <typename Entry, typename Allocator = std::allocator<Entry>>
  std::vector<Entry, Allocator> read() {
    std::vector<Entry, Allocator> entries(header_.entries);
    read(std::as_writable_bytes(std::span(entries)));
    return entries;
  }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void read(std::span<std::byte> bytes);

  std::filesystem::path file_;
  std::ifstream stream_;
  BakedHeader header_;
};

}  // namespace lightbench
