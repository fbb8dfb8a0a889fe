#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/problem_list.h"
#include "scene/scene.h"

namespace lightbench {

/// Where the file that an OBJ or MTL names is. Backslashes count as slashes. Where nothing has that name, a
/// file that differs in case only is taken, or one of its last component beside `folder` (a path of somebody
/// else's machine); `found_elsewhere` says so. Nothing if there is none.
struct FoundFile {
  std::filesystem::path file;
  bool found_elsewhere = false;
};
std::optional<FoundFile> find_named_file(const std::string& name, const std::filesystem::path& folder);

/// What OpenGL holds here.
inline constexpr int kMaxTextureSide = 16384;

/// Reads each texture once. A file that cannot be read is one problem, and gives kNoTexture.
class TextureLoader {
 public:
  explicit TextureLoader(ProblemList& problems) : problems_(problems) {}

  /// A colour texture. `name` is as the MTL file in `folder` writes it, `where` is the place of that.
  TextureIndex color(const std::string& name, const std::filesystem::path& folder, const std::string& where);

  /// A cut-out: the file's alpha if it has one that is used, else its red as alpha. A file without a used
  /// alpha that is also the material's colour texture (`color`, or kNoTexture) cannot mean a mask, and gives
  /// kNoTexture.
  TextureIndex cutout(const std::string& name, const std::filesystem::path& folder, const std::string& where,
                      TextureIndex color);

  std::vector<Texture> take_textures() { return std::move(textures_); }
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  std::optional<std::filesystem::path> locate(const std::string& name, const std::filesystem::path& folder,
                                              const std::string& where);
  TextureIndex load(const std::filesystem::path& file, const std::string& where);

  ProblemList& problems_;
  std::vector<Texture> textures_;
  std::vector<std::filesystem::path> files_;
  std::map<std::filesystem::path, TextureIndex> loaded_;  // kNoTexture for those that failed
  std::map<std::filesystem::path, TextureIndex> masks_;   // made from red
};

}  // namespace lightbench
