#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lightbench {

/// A file that is to be read or written, and what it is to the user: "--diff", "the scene".
struct NamedFile {
  std::string name;
  std::filesystem::path path;  ///< empty: not asked for
};

/// Throws Error, with the path, where two outputs are one file or an output is an input, however the paths
/// are spelled and through whatever links they lead. To be asked before anything is computed.
void check_outputs(std::span<const NamedFile> outputs, std::span<const NamedFile> inputs);

/// Returns the paths as files of one name.
std::vector<NamedFile> named(const std::string& name, std::span<const std::filesystem::path> paths);

}  // namespace lightbench
