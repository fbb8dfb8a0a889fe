#pragma once

#include <filesystem>

#include "renderer/radiance/baked_file.h"
#include "renderer/radiance/radiance_stack.h"

/// `.mtex` files: a stack of radiance as it is, 3 components of 8 or 16 bits, texel by texel in its order
/// (docs/formats.md). All throw Error with the file's name.
namespace lightbench {

/// Whole or not there. Texels go from memory to the disk without a copy.
void write_radiance(const std::filesystem::path& file, const HalfStack& stack);
void write_radiance(const std::filesystem::path& file, const ByteStack& stack);

/// The header alone, checked against the file's length. Its `bits` tell which kind it is: 8 or 16.
BakedHeader read_radiance_header(const std::filesystem::path& file);

/// Each reads its own kind only.
HalfStack read_half_radiance(const std::filesystem::path& file);
ByteStack read_byte_radiance(const std::filesystem::path& file);

}  // namespace lightbench
