#pragma once

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/image.h"

namespace lightbench {

/// How the rows and columns of a file lie in the picture, as cameras note it: 1 as stored, 2 mirrored, 3
/// turned by 180 degrees, 4 upside down, 5 mirrored along the diagonal, 6 to be turned clockwise by 90
/// degrees, 7 mirrored along the other diagonal, 8 to be turned counterclockwise (Exif 2.32, 4.6.4, tag 274).
using Orientation = int;

constexpr bool swaps_sides(Orientation orientation) {
  return orientation >= 5;
}

/// The picture that is stored so.
template <typename Component>
BasicImage<Component> upright(BasicImage<Component> stored, Orientation orientation) {
  if (orientation == 1) return stored;
  const bool swapped = swaps_sides(orientation);
  const bool from_right = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
  const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
  BasicImage<Component> result(stored.width, stored.height, stored.channels);
  if (swapped) std::swap(result.width, result.height);
  for (int y = 0; y < stored.height; ++y)
    for (int x = 0; x < stored.width; ++x) {
      const int column = swapped ? y : x, row = swapped ? x : y;
      std::ranges::copy(stored.pixel(x, y), result
                                                .pixel(from_right ? result.width - 1 - column : column,
                                                       from_bottom ? result.height - 1 - row : row)
                                                .begin());
    }
  return result;
}

/// What the bytes of an Exif block say, which are those of a TIFF file; 1 where they say nothing that makes
/// sense.
Orientation exif_orientation(std::string_view exif);

/// Returns the orientation of a WebP file, whose Exif block OpenImageIO does not read. Throws Error where the
/// file cannot be read.
Orientation read_webp_orientation(const std::filesystem::path& file);

}  // namespace lightbench
