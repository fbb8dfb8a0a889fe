#include "renderer/techniques/images.h"

#include <fmt/format.h>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/image_io.h"
#include "base/text.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

void check_picture(const Image& picture, const FrameRequest& request, const std::string& file) {
  if (picture.width != request.width || picture.height != request.height)
    throw Error(fmt::format("the picture has {}x{} pixels, but {}x{} are wanted", picture.width,
                            picture.height, request.width, request.height),
                file);
  if (const auto bad = first_non_finite(picture); bad >= 0) {
    const auto pixel = bad / picture.channels;
    throw Error(
        fmt::format("pixel ({}, {}) is not a finite number", pixel % picture.width, pixel / picture.width),
        file);
  }
}

Image with_alpha(Image picture) {
  if (picture.channels == 4) return picture;
  Image result(picture.width, picture.height, 4, 1.0f);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c) result.data[4 * i + c] = picture.data[3 * i + c];
  return result;
}

void render_images(FrameContext& frame, const ParamValues& params) {
  const FrameRequest& request = frame.request();
  const std::string file = picture_path(params.text("pattern"), request.scene.name, request.view.name);
  Image picture;
  frame.result().picture_hash =
      hash_while_reading(file, [&] { picture = read_image(file, params.text("layer")); });
  check_picture(picture, request, file);
  frame.set_image(with_alpha(std::move(picture)));
}

}  // namespace

std::string picture_path(std::string_view pattern, std::string_view scene, std::string_view view) {
  std::string result;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool brace = pattern.compare(i, 2, "{{") == 0;
    if (pattern[i] != '{' || brace) {
      result += pattern[i];
      i += brace ? 1 : 0;
      continue;
    }
    const std::size_t end = pattern.find('}', i);
    const std::string word(pattern.substr(i + 1, end == std::string_view::npos ? end : end - i - 1));
    if (end == std::string_view::npos) throw Error("a '{' without its '}'", "parameter 'pattern'");
    if (word != "scene" && word != "view")
      throw Error(fmt::format("only {{scene}} and {{view}} are replaced, not '{{{}}}'{}", word,
                              did_you_mean(word, {"scene", "view"})),
                  "parameter 'pattern'");
    result += escape_file_name(word == "scene" ? scene : view);
    i = end;
  }
  return result;
}

Technique images_technique() {
  Technique technique;
  technique.name = "images";
  technique.doc = "pictures of another engine, read from files and scored like any other variant";
  technique.params = {
      text_param(
          "pattern", "renders/{scene}/{view}.png",
          "path of a view's picture; {scene} and {view} stand for the names, in which bytes other than "
          "letters, digits, '.', '_' and '-' become %XX; {{ is a brace; ${LIGHTBENCH_...} is an "
          "environment variable; relative to the job file's folder, and on the command line to the "
          "working directory. 8- and 16-bit files are taken as sRGB, EXR as linear light"),
      text_param(
          "layer", "",
          "layer or part to read in OpenEXR files that have named ones; empty: the one without a name, "
          "or the only one with colour")};
  technique.needs_gl = false;
  technique.external = true;
  technique.shows_water = true;
  technique.render = render_images;
  return technique;
}

}  // namespace lightbench
