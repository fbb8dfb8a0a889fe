#pragma once

#include <string>
#include <vector>

namespace lightbench {

/// The channels of one part of a file. Files of most formats have one part without a name.
struct FilePart {
  std::string name;
  std::vector<std::string> channels;
};

/// Where a picture is in a file.
struct PictureChannels {
  std::size_t part = 0;
  std::vector<int> indices;  ///< red, green, blue or one luminance, and then alpha if there is one
  bool has_alpha = false;
};

/// Finds the channels of a picture by their names. What a name has before its last dot is its layer; the name
/// of a part of several is the layer, too, or the first part of its name. A layer has colour if it has the
/// channels R, G and B, or Y; the names Red, Green, Blue and Luminance, and lower case, mean the same. Alpha
/// is a channel A or Alpha of the same layer, and nothing else is.
///
/// Without a wanted layer it is the layer without a name that counts, or the only one that has colour. The
/// wanted one is looked for in files that have named layers; a file without them has one picture, and that is
/// taken. Throws Error(..., where) that names the layers to choose from, or the channels where none has
/// colour.
PictureChannels find_picture(const std::vector<FilePart>& parts, const std::string& wanted_layer,
                             const std::string& where);

}  // namespace lightbench
