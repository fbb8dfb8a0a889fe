#include "scene/texture_loader.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/image_io.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

bool uses_alpha(const Image8& rgba) {
  for (std::size_t i = 3; i < rgba.data.size(); i += 4)
    if (rgba.data[i] != 255) return true;
  return false;
}

}  // namespace

// The textures of several files are counted together, so their number has no place but the scene.
TextureLoader::TextureLoader(ProblemList& problems)
    : problems_(problems),
      unreadable_(problems, Problem::Severity::error, "textures that cannot be read", "") {}

std::vector<Texture> TextureLoader::take_textures() {
  unreadable_.finish();
  return std::move(textures_);
}

std::optional<fs::path> TextureLoader::locate(const std::string& name, const fs::path& folder,
                                              const std::string& where) {
  const auto found = named_files_.find(name, folder);
  if (!found) {
    const fs::path missing = folder / with_slashes(name);
    if (loaded_.try_emplace(missing, kNoTexture).second)
      unreadable_.add(fmt::format("the texture '{}' {}", missing.lexically_normal().string(),
                                  why_not_found(name, folder)),
                      where);
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
  try {
    Image8 pixels;
    std::string hash = hash_while_reading(file, [&] { pixels = read_image_rgba8(file, kMaxTextureSide); });
    files_.push_back({file, std::move(hash)});
    textures_.push_back({file, std::move(pixels)});
    entry->second = TextureIndex(textures_.size()) - 1;
  } catch (const Error& error) {
    unreadable_.add(fmt::format("the texture '{}': {}", file.string(), error.message()), where);
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
