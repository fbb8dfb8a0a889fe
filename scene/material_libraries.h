#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/mtl_loader.h"
#include "scene/named_files.h"
#include "scene/obj_text.h"
#include "scene/problem_list.h"
#include "scene/scene.h"

namespace lightbench {

/// The material libraries of an OBJ file. Of several materials with one name the first that was read counts.
class MaterialLibraries {
 public:
  /// `used` are the names of materials that faces have; it must outlive this object.
  MaterialLibraries(const std::filesystem::path& obj_file, const std::set<std::string>& used,
                    ProblemList& problems);

  /// Reads what a statement `mtllib` names. A library that cannot be read is an error, and the others are
  /// read.
  void read(const TextLine& statement);

  /// Nothing where no library has the material.
  const MtlMaterial* find(const std::string& name) const;
  const std::map<std::string, MtlMaterial>& materials() const { return materials_; }
  const std::vector<SourceFile>& files() const { return files_; }  ///< that were read
  bool lacks_one() const { return lacks_one_; }                    ///< that was named

 private:
  void read_file(const std::filesystem::path& file);
  void add(MtlMaterial&& material);

  const std::filesystem::path& obj_file_;
  const std::set<std::string>& used_;
  ProblemList& problems_;
  RepeatedProblem missing_;
  RepeatedProblem duplicates_;
  NamedFiles named_files_;
  std::set<std::filesystem::path> known_;
  std::vector<SourceFile> files_;
  std::map<std::string, MtlMaterial> materials_;
  bool lacks_one_ = false;
};

}  // namespace lightbench
