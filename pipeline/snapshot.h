#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/image_io.h"
#include "renderer/renderer.h"

namespace lightbench {

/// Linear half-float EXR and the rounded sRGB PNG of what that EXR holds. Throws Error, before anything is
/// written, for an image with NaN or infinity. Returns warnings about the image.
std::vector<std::string> write_image_pair(const std::filesystem::path& exr, const std::filesystem::path& png,
                                          const Image& image, const ImageMetadata& metadata);

/// A picture for people, by the extension: .png, the rounded sRGB without alpha, or .exr, linear half floats.
/// The same errors and warnings.
std::vector<std::string> write_picture(const std::filesystem::path& file, const Image& image);

/// A named buffer as 32-bit EXR, and as a PNG to look at: one-component buffers in grey from their least to
/// their greatest value, others clamped to 0..1; buffers with negative values are shifted from -1..1 first.
void write_buffer_pair(const std::filesystem::path& exr, const std::filesystem::path& png,
                       const Image& buffer);

/// Throws Error where a file could not be written; leaves none.
void require_writable(const std::filesystem::path& file);

GlBackend parse_gl(const std::string& text, const std::string& where);

}  // namespace lightbench
