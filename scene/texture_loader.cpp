#include "scene/texture_loader.h"

#include <algorithm>
#include <array>
#include <system_error>

#include <fmt/format.h>
#include <strings.h>

#include "base/error.h"
#include "base/image_io.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

std::string with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const bool quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
  return quoted ? name.substr(1, name.size() - 2) : name;
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// The entry of `folder` that is `name` but for case, or nothing.
std::optional<fs::path> entry_ignoring_case(const fs::path& folder, const std::string& name) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, error), end; !error && it != end;
       it.increment(error))
    if (::strcasecmp(it->path().filename().c_str(), name.c_str()) == 0)
      found.push_back(folder / it->path().filename());
  if (found.empty()) return std::nullopt;
  return *std::min_element(found.begin(), found.end());
}

// The path with each component found but for case.
std::optional<fs::path> path_ignoring_case(const fs::path& folder, const fs::path& relative) {
  fs::path path = folder;
  for (const fs::path& component : relative) {
    if (component == "." || component == "..") {
      path /= component;
      continue;
    }
    const auto entry = entry_ignoring_case(path, component.string());
    if (!entry) return std::nullopt;
    path = *entry;
  }
  return is_file(path) ? std::optional(path) : std::nullopt;
}

Image8 with_alpha(Image8 image) {
  if (image.channels == 4) return image;
  Image8 result(image.width, image.height, 4, 255);
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    std::copy_n(&image.data[i * 3], 3, &result.data[i * 4]);
  return result;
}

bool uses_alpha(const Image8& rgba) {
  for (std::size_t i = 3; i < rgba.data.size(); i += 4)
    if (rgba.data[i] != 255) return true;
  return false;
}

}  // namespace

std::optional<FoundFile> find_named_file(const std::string& name, const fs::path& folder) {
  const fs::path named = with_slashes(name);
  if (named.empty() || named.string().find('\0') != std::string::npos) return std::nullopt;
  if (const fs::path exact = (folder / named).lexically_normal(); is_file(exact))
    return FoundFile{exact, false};
  if (named.is_relative())
    if (const auto path = path_ignoring_case(folder, named)) return FoundFile{path->lexically_normal(), true};
  if (named.filename().empty()) return std::nullopt;
  if (const auto path = path_ignoring_case(folder, named.filename())) return FoundFile{*path, true};
  return std::nullopt;
}

std::optional<fs::path> TextureLoader::locate(const std::string& name, const fs::path& folder,
                                              const std::string& where) {
  const auto found = find_named_file(name, folder);
  if (!found) {
    const fs::path missing = folder / with_slashes(name);
    if (loaded_.try_emplace(missing, kNoTexture).second)
      problems_.error(fmt::format("the texture '{}' is missing", missing.lexically_normal().string()), where);
    return std::nullopt;
  }
  if (found->found_elsewhere && !loaded_.contains(found->file))
    problems_.warning(fmt::format("there is no texture '{}'; '{}' is used", name, found->file.string()),
                      where);
  return found->file;
}

TextureIndex TextureLoader::load(const fs::path& file, const std::string& where) {
  const auto [entry, inserted] = loaded_.try_emplace(file, kNoTexture);
  if (!inserted) return entry->second;
  files_.push_back(file);
  try {
    Image8 pixels = read_image_srgb8(file);
    if (std::max(pixels.width, pixels.height) > kMaxTextureSide)
      throw Error(fmt::format("{} x {} pixels are more than {} a side", pixels.width, pixels.height,
                              kMaxTextureSide));
    textures_.push_back({file, with_alpha(std::move(pixels))});
    entry->second = TextureIndex(textures_.size()) - 1;
  } catch (const Error& error) {
    problems_.error(fmt::format("the texture '{}': {}", file.string(), error.message()), where);
  }
  return entry->second;
}

TextureIndex TextureLoader::color(const std::string& name, const fs::path& folder, const std::string& where) {
  const auto file = locate(name, folder, where);
  return file ? load(*file, where) : kNoTexture;
}

TextureIndex TextureLoader::cutout(const std::string& name, const fs::path& folder, const std::string& where,
                                   TextureIndex color) {
  const auto file = locate(name, folder, where);
  const TextureIndex plain = file ? load(*file, where) : kNoTexture;
  if (plain == kNoTexture || uses_alpha(textures_[std::size_t(plain)].pixels)) return plain;
  if (plain == color) return kNoTexture;
  const auto [entry, inserted] = masks_.try_emplace(*file, TextureIndex(textures_.size()));
  if (inserted) {
    Texture mask = textures_[std::size_t(plain)];
    for (std::size_t i = 0; i < mask.pixels.data.size(); i += 4)
      mask.pixels.data[i + 3] = mask.pixels.data[i];
    textures_.push_back(std::move(mask));
  }
  return entry->second;
}

}  // namespace lightbench
