#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/image_io.h"
#include "renderer/renderer.h"

namespace lightbench {

/// Linear half-float EXR and the rounded sRGB PNG of what that EXR holds.
void write_image_pair(const std::filesystem::path& exr, const std::filesystem::path& png, const Image& image,
                      const ImageMetadata& metadata);

/// A named buffer as 32-bit EXR, and as a PNG to look at: one-component buffers in grey from their least to
/// their greatest value, others clamped to 0..1; buffers with negative values are shifted from -1..1 first.
void write_buffer_pair(const std::filesystem::path& exr, const std::filesystem::path& png,
                       const Image& buffer);

/// Throws Error where a file could not be written; leaves none.
void require_writable(const std::filesystem::path& file);

GlBackend parse_gl(const std::string& text, const std::string& where);

}  // namespace lightbench
