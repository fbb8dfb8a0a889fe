#include "base/picture_file.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "base/bmp_header.h"
#include "base/error.h"
#include "base/exr_header.h"
#include "base/files.h"
#include "base/image_io.h"
#include "base/input_file.h"
#include "base/jpeg_end.h"
#include "base/openimageio.h"
#include "base/picture_pixels.h"
#include "base/png_header.h"
#include "base/text.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

bool is(const ImageKind& kind, std::string_view reader) {
  return kind.reader == reader;
}

/// So that a few bytes cannot ask for gigabytes.
void check_plausible_size(std::int64_t width, std::int64_t height, const ImageKind& kind,
                          const fs::path& file) {
  check_image_size(width, height, file.string());
  const std::uint64_t bytes = fs::file_size(file);
  if (bytes > kLargestPictureFile)
    throw Error("is larger than any picture that is read: " + bytes_text(bytes), file.string());
  if (std::uint64_t(width) * std::uint64_t(height) / kind.most_pixels_per_byte > bytes)
    throw Error(fmt::format("damaged image: {} bytes cannot hold {} x {} pixels", bytes, width, height),
                file.string());
}

/// Returns the number of parts.
std::size_t check_exr_header(const ImageKind& kind, const fs::path& file) {
  const auto parts = read_exr_parts(file);
  if (!parts) throw Error("damaged OpenEXR image: its header does not end within the file", file.string());
  for (const ExrPart& part : *parts) {
    check_plausible_size(part.data_width, part.data_height, kind, file);
    check_plausible_size(part.display_width, part.display_height, kind, file);
  }
  return parts->size();
}

/// Only the reader of the file's kind is tried.
std::unique_ptr<OIIO::ImageInput> open_input(const ImageKind& kind, const fs::path& file) {
  configure_openimageio();
  auto input = OIIO::ImageInput::create(kind.reader);
  if (!input) throw Error(fmt::format("OpenImageIO cannot read {} here", kind.name), file.string());
  OIIO::ImageSpec config, spec;
  config.attribute("oiio:UnassociatedAlpha", 1);
  if (input->open(file.string(), spec, config)) return input;
  const std::string reason = one_line(input->geterror());
  throw Error(fmt::format("cannot be read as a {} image: {}", kind.name,
                          reason.empty() ? "its header is damaged or cut" : reason),
              file.string());
}

void check_flat(const OIIO::ImageSpec& spec, const fs::path& file) {
  if (spec.deep)
    throw Error("is a deep image, with several depths in a pixel; only flat ones are read", file.string());
  if (spec.depth > 1) throw Error("is a volume of several layers; only flat images are read", file.string());
  if (spec.nchannels < 1) throw Error("is an image without components", file.string());
}

/// OpenImageIO calls the components of some files of two R and G.
std::vector<std::string> channel_names(const OIIO::ImageSpec& spec, const ImageKind& kind) {
  if (is(kind, "openexr") || spec.nchannels != 2) return spec.channelnames;
  return {"Y", spec.alpha_channel == 1 || is(kind, "targa") ? "A" : "unknown"};
}

/// Deep parts and those that cannot be read have no channels here.
std::vector<FilePart> parts_of(OIIO::ImageInput& input, const ImageKind& kind, std::size_t count,
                               const fs::path& file) {
  std::vector<FilePart> parts(count);
  for (std::size_t i = 0; i < count; ++i) {
    const OIIO::ImageSpec spec = input.spec(int(i), 0);
    parts[i].name = spec.get_string_attribute("oiio:subimagename");
    if (!spec.deep) parts[i].channels = channel_names(spec, kind);
  }
  // An error of a part that is not looked at would be taken for one of the pixels that are.
  static_cast<void>(input.geterror());
  if (std::ranges::all_of(parts, &std::vector<std::string>::empty, &FilePart::channels))
    check_flat(input.spec(0, 0), file);
  return parts;
}

constexpr int kPremultipliedTga = 4;

/// A TGA file says in two places whether its fourth byte is alpha; OpenImageIO looks at both.
bool tga_has_alpha(const OIIO::ImageSpec& spec) {
  return spec.nchannels == 2 || spec.get_int_attribute("oiio:UnassociatedAlpha") == 1 ||
         spec.get_int_attribute("targa:alpha_type") == kPremultipliedTga;
}

void drop_alpha_that_is_none(PictureChannels& picture, const OIIO::ImageSpec& spec, const ImageKind& kind,
                             const fs::path& file) {
  if (!picture.has_alpha) return;
  if (is(kind, "bmp")) picture.has_alpha = read_bmp_has_alpha(file);
  if (is(kind, "targa")) picture.has_alpha = tga_has_alpha(spec);
  if (!picture.has_alpha) picture.indices.pop_back();
}

/// OpenImageIO multiplies the colours of WebP by alpha, whatever it is asked for.
bool is_premultiplied_file(const OIIO::ImageSpec& spec, const ImageKind& kind) {
  if (is(kind, "bmp")) return false;
  if (is(kind, "targa")) return spec.get_int_attribute("targa:alpha_type") == kPremultipliedTga;
  return spec.get_int_attribute("oiio:UnassociatedAlpha") != 1;
}

Transfer transfer_of(const OIIO::ImageSpec& spec, const ImageKind& kind, const std::optional<float>& png) {
  if (png) return {Transfer::Kind::power, *png};
  const float gamma = is(kind, "hdr") ? spec.get_float_attribute("oiio:Gamma", 1.0f) : 1.0f;
  if (gamma != 1 && gamma > 0) return {Transfer::Kind::power, gamma};
  return {spec.format.is_floating_point() ? Transfer::Kind::linear : Transfer::Kind::srgb};
}

/// Other formats have none, or OpenImageIO passes on what another file said that the pixels came from.
Orientation orientation_of(const OIIO::ImageSpec& spec, const ImageKind& kind, const fs::path& file) {
  if (is(kind, "webp")) return read_webp_orientation(file);
  const int value = spec.get_int_attribute("Orientation", 1);
  if (value < 1 || value > 8) return 1;
  // OpenImageIO takes +X +Y for 6 and -X -Y for 8, but the first line of such files is the left column from
  // its bottom, and the right one from its top.
  if (is(kind, "hdr")) return value == 6 ? 8 : value == 8 ? 6 : value;
  return is(kind, "jpeg") || is(kind, "tiff") || is(kind, "png") ? value : 1;
}

void check_light(const PictureChannels& picture, const OIIO::ImageSpec& spec, const fs::path& file) {
  for (const int channel : picture.indices)
    if (!spec.channelformat(channel).is_floating_point())
      throw Error(fmt::format("the channel '{}' holds whole numbers, as of objects, and no light",
                              spec.channel_name(channel)),
                  file.string());
}

PictureChannels first_four(const OIIO::ImageSpec& spec) {
  PictureChannels channels;
  channels.indices.resize(std::size_t(std::min(spec.nchannels, 4)));
  std::iota(channels.indices.begin(), channels.indices.end(), 0);
  return channels;
}

}  // namespace

PictureFile::PictureFile(const fs::path& file, const std::string& layer, Channels channels)
    : file_(file), kind_(&image_kind(file)) {
  const bool exr = is(*kind_, "openexr");
  const std::size_t parts = exr ? check_exr_header(*kind_, file) : 1;
  const auto png = is(*kind_, "png") ? read_png_exponent(file) : std::nullopt;
  input_ = open_input(*kind_, file);
  picture_ = channels == Channels::first_four
                 ? first_four(input_->spec(0, 0))
                 : find_picture(parts_of(*input_, *kind_, parts, file), layer, file.string());
  spec_ = input_->spec(int(picture_.part), 0);
  check_flat(spec_, file);
  if (!exr) check_plausible_size(spec_.width, spec_.height, *kind_, file);
  if (is(*kind_, "jpeg") && !reaches_jpeg_end(read_file(file)))
    throw Error("truncated JPEG image: it does not reach its end", file.string());
  if (exr && channels == Channels::picture) check_light(picture_, spec_, file);
  drop_alpha_that_is_none(picture_, spec_, *kind_, file);
  transfer_ = transfer_of(spec_, *kind_, png);
  orientation_ = orientation_of(spec_, *kind_, file);
  premultiplied_ = picture_.has_alpha && is_premultiplied_file(spec_, *kind_);
  // Only OpenEXR's display window is the picture: other formats have places on a page.
  if (exr) return;
  spec_.full_x = spec_.x, spec_.full_y = spec_.y;
  spec_.full_width = spec_.width, spec_.full_height = spec_.height;
}

int PictureFile::width() const {
  return swaps_sides(orientation_) ? spec_.full_height : spec_.full_width;
}

int PictureFile::height() const {
  return swaps_sides(orientation_) ? spec_.full_width : spec_.full_height;
}

template <typename Component>
BasicImage<Component> PictureFile::read(int components, Component other) {
  BasicImage<Component> image(spec_.full_width, spec_.full_height, components, other);
  read_pixels(image, *input_, spec_, picture_, file_);
  return upright(std::move(image), orientation_);
}

template Image PictureFile::read(int, float);
template Image8 PictureFile::read(int, std::uint8_t);

}  // namespace lightbench
