#pragma once

#include <filesystem>

#include "renderer/radiance/pca.h"

/// `.mtpc` files: a PcaStack as it is (docs/formats.md). Both throw Error with the file's name.
namespace lightbench {

/// Whole or not there.
void write_pca(const std::filesystem::path& file, const PcaStack& stack);

/// What it returns can be decoded: the header is checked against the file's length before anything is
/// allocated, then the corrections.
PcaStack read_pca(const std::filesystem::path& file);

}  // namespace lightbench
