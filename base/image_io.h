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

/// Any file of a kind that is read (base/image_kinds.h), as linear light. Colour is premultiplied: it is what
/// is seen over black, whatever the file has, and alpha, which is linear, stands aside. OpenEXR and some TIFF
/// files have it so already; that of others is multiplied by alpha in linear light.
///
/// Files of integers are decoded from sRGB, or by what a PNG says of its gamma; files of floats are taken as
/// they are, but for an HDR file's GAMMA. Colour is found by the names of channels, of the layer if one is
/// named (base/image_layers.h); grey becomes RGB, grey with alpha RGBA. The picture is OpenEXR's display
/// window, 0 where it has no data, and it is turned as Exif says. Throws Error (missing, truncated, of
/// another kind, deep, too large, of a size that its bytes cannot hold, without colour, of several layers to
/// choose from) with the path.
Image read_image(const std::filesystem::path& file, const std::string& layer = "");

/// The same picture on the 0..255 scale of the scores: the rounded sRGB of clamped linear values, which are
/// the components of opaque sRGB files as stored (16 bits rounded to 8). NaN and infinity are an Error.
Image8 read_image_srgb8(const std::filesystem::path& file, const std::string& layer = "");

/// The same as RGBA for textures, alpha being 255 where the file has none. Colour is not premultiplied, so
/// that it can be interpolated where nothing is seen of it. Where the file has 8 bits, it takes no more
/// memory than the result. Throws Error for one with more than `max_side` pixels a side, before they are
/// read.
Image8 read_image_rgba8(const std::filesystem::path& file, int max_side = kMaxImageSide);

/// A float buffer of 1 to 4 components exactly as stored, with no conversion and in the order of the file;
/// for the OpenEXR files that lightbench and POV-Ray write.
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
