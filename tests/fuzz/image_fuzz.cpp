#include "base/error.h"
#include "base/image_io.h"
#include "fuzz_input.h"

namespace lightbench::fuzz {

/// An image of any kind. What it holds decides which, but for TGA, which only its name tells. All ways to
/// read it agree on its size.
void fuzz_image(std::string_view bytes) {
  static const InputFolder folder;
  const auto file = folder.write("image.tga", bytes);
  read_image_metadata(file);
  const Image stored = read_float_image(file);
  const Image linear = read_image(file);
  require(stored.width == linear.width && stored.height == linear.height, "two sizes of one image");
  require(linear.channels == 3 || linear.channels == 4, "an image that is not of colours");
  const Image8 shown = read_image_srgb8(file);
  require(shown.width == linear.width && shown.height == linear.height, "two sizes of one image");
  const Image8 texture = read_image_rgba8(file);
  require(texture.width == linear.width && texture.height == linear.height, "two sizes of one image");
  require(texture.channels == 4, "a texture without alpha");
}

}  // namespace lightbench::fuzz
