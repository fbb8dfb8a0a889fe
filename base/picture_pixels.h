#pragma once

#include <filesystem>

#include <OpenImageIO/imageio.h>

#include "base/image.h"
#include "base/image_layers.h"

namespace lightbench {

/// Reads a picture's channels into the first components of `image`, which has the size of the display window
/// in `spec`. They become 0 where that window has no data; data outside of it takes no memory. Throws Error
/// with the path for pixels that are damaged or cut.
template <typename Component>
void read_pixels(BasicImage<Component>& image, OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                 const PictureChannels& picture, const std::filesystem::path& file);

}  // namespace lightbench
