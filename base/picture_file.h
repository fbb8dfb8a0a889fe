#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <OpenImageIO/imageio.h>

#include "base/image.h"
#include "base/image_kinds.h"
#include "base/image_layers.h"
#include "base/orientation.h"
#include "base/transfer.h"

namespace lightbench {

/// A picture file that is open: the one way by which all readers of base/image_io.h come to pixels. It gives
/// the numbers as stored, and says what they mean.
class PictureFile {
 public:
  enum class Channels {
    picture,     ///< red, green and blue or a luminance, and alpha, by their names
    first_four,  ///< of the first part, whatever they are
  };

  /// `layer` as in find_picture. Throws Error with the path.
  PictureFile(const std::filesystem::path& file, const std::string& layer, Channels channels);

  /// The size of the picture as it is looked at: an OpenEXR file's display window, turned as the file says.
  int width() const;
  int height() const;
  int channels() const { return int(picture_.indices.size()); }
  bool has_alpha() const { return picture_.has_alpha; }
  /// Whether the stored colours are multiplied by alpha, which is done after they are encoded.
  bool is_premultiplied() const { return premultiplied_; }
  const Transfer& transfer() const { return transfer_; }
  const OIIO::ImageSpec& spec() const { return spec_; }

  /// The numbers in the first components of pixels of at least as many; integers on the scale of `Component`.
  /// Where a display window has no data they are 0. The other components have `other`.
  template <typename Component>
  BasicImage<Component> read(int components, Component other = {});

 private:
  std::filesystem::path file_;
  const ImageKind* kind_;
  std::unique_ptr<OIIO::ImageInput> input_;
  OIIO::ImageSpec spec_;  // of the picture's part
  PictureChannels picture_;
  Transfer transfer_;
  Orientation orientation_ = 1;
  bool premultiplied_ = false;
};

}  // namespace lightbench
