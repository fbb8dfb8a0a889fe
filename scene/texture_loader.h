#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/named_files.h"
#include "scene/problem_list.h"
#include "scene/scene.h"

namespace lightbench {

/// What OpenGL holds here.
inline constexpr int kMaxTextureSide = 16384;

/// Reads each texture once. A file that cannot be read is one problem, and gives kNoTexture.
class TextureLoader {
 public:
  explicit TextureLoader(ProblemList& problems);

  /// A colour texture. `name` is as the MTL file in `folder` writes it, `where` is the place of that.
  TextureIndex color(const std::string& name, const std::filesystem::path& folder, const std::string& where);

  /// A cut-out: the file's alpha if it has one that is used, else its red as alpha. A file without a used
  /// alpha that is also the material's colour texture (`color`, or kNoTexture) cannot mean a mask, and gives
  /// kNoTexture.
  TextureIndex cutout(const std::string& name, const std::filesystem::path& folder, const std::string& where,
                      TextureIndex color);

  /// Ends the list of problems, too.
  std::vector<Texture> take_textures();
  const std::vector<SourceFile>& files() const { return files_; }

 private:
  std::optional<std::filesystem::path> locate(const std::string& name, const std::filesystem::path& folder,
                                              const std::string& where);
  TextureIndex load(const std::filesystem::path& file, const std::string& where);

  ProblemList& problems_;
  RepeatedProblem unreadable_;
  NamedFiles named_files_;
  std::vector<Texture> textures_;
  std::vector<SourceFile> files_;
  std::map<std::filesystem::path, TextureIndex> loaded_;  // kNoTexture for those that failed
  std::map<std::filesystem::path, TextureIndex> masks_;   // made from red
};

}  // namespace lightbench
