#pragma once

#include <filesystem>
#include <vector>

#include "renderer/radiance/codec_report.h"
#include "renderer/radiance/piecewise.h"

/// The four files of a PiecewiseStack (docs/formats.md): `.mtnc` the colour index of each sample, `.mti` its
/// layer, `.mtm` the colours, `.mtsp` the first sample of each texel. `stem` is their common name, to which
/// the extensions are added.
namespace lightbench {

/// No file takes its place before all four are on the disk. Throws Error where they cannot be written.
void write_piecewise(const std::filesystem::path& stem, const PiecewiseStack& stack);

/// What it returns can be decoded: each file, and what they say of one another, is checked. Throws Error with
/// the name of the file that is missing, damaged, or does not go with the others.
PiecewiseStack read_piecewise(const std::filesystem::path& stem);

/// How large the files are, or would be.
std::vector<FileSize> piecewise_file_sizes(const PiecewiseStack& stack);

}  // namespace lightbench
