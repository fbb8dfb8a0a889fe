#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/image.h"

namespace lightbench {

/// Largest width or height that is accepted anywhere, and largest number of pixels of one image.
inline constexpr int kMaxImageSide = 32768;
inline constexpr std::size_t kMaxImagePixels = std::size_t(1) << 28;

/// Text attributes of an image file (EXR header, PNG text).
using ImageMetadata = std::map<std::string, std::string>;

enum class PixelType { half, float32 };

/// Any file of a kind that is read (base/image_kinds.h), as linear light: 8- and 16-bit integer files are
/// decoded from sRGB (alpha is linear), float files are taken as they are. Grey becomes RGB, grey with alpha
/// RGBA; alpha is kept and colour is not divided by it. Throws Error (missing, truncated, of another kind,
/// deep, too large, of a size that its bytes cannot hold) with the path.
Image read_image(const std::filesystem::path& file);

/// The same file on the 0..255 scale of the scores: integer files as stored (16 bits rounded to 8), float
/// files as the rounded sRGB of their clamped linear values; those with NaN or infinity are an Error.
Image8 read_image_srgb8(const std::filesystem::path& file);

/// The same as RGBA, alpha being 255 where the file has none, in no more memory than the result takes where
/// the file has 8 bits. Throws Error for one with more than `max_side` pixels a side, before they are read.
Image8 read_image_rgba8(const std::filesystem::path& file, int max_side = kMaxImageSide);

/// A float buffer of 1 to 4 components exactly as stored, with no conversion; for EXR.
Image read_float_image(const std::filesystem::path& file);

ImageMetadata read_image_metadata(const std::filesystem::path& file);

/// All writers write beside the target and rename: a file is whole or not there. They throw Error with the
/// path.
///
/// Numbers that 16 bits cannot hold (they would become infinite) are written as kLargestHalf or its negative;
/// returns how many pixels have one. Infinity and NaN are written as they are.
std::size_t write_exr(const std::filesystem::path& file, const Image& image, PixelType type,
                      const ImageMetadata& metadata = {});
/// 8-bit PNG as given, 1 to 4 components, without time stamps: equal images give equal bytes.
void write_png(const std::filesystem::path& file, const Image8& image);
/// The same PNG as bytes in memory.
std::string encode_png(const Image8& image);

/// Throws Error(..., where) unless 1 <= side <= kMaxImageSide and the pixel count is acceptable.
void check_image_size(long long width, long long height, const std::string& where);

}  // namespace lightbench
