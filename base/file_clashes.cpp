#include "base/file_clashes.h"

#include <map>

#include <fmt/format.h>
#include <sys/stat.h>

#include "base/error.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

/// Two paths lead to one file where they have one of these in common: its place, with all links followed, and
/// its number on the device, which hard links share.
std::vector<std::string> identities(const fs::path& file) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(file, error), error);
  std::vector<std::string> result{(error ? file.lexically_normal() : place).string()};
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0)
    result.push_back(fmt::format("{}:{}", status.st_dev, status.st_ino));
  return result;
}

}  // namespace

void check_outputs(std::span<const NamedFile> outputs, std::span<const NamedFile> inputs) {
  std::map<std::string, const NamedFile*> read, written;
  for (const NamedFile& input : inputs)
    if (!input.path.empty())
      for (const std::string& identity : identities(input.path)) read.emplace(identity, &input);
  for (const NamedFile& output : outputs) {
    if (output.path.empty()) continue;
    for (const std::string& identity : identities(output.path)) {
      if (const auto input = read.find(identity); input != read.end())
        throw Error(fmt::format("{} would be overwritten by {}", input->second->name, output.name),
                    output.path.string());
      const auto [other, is_new] = written.emplace(identity, &output);
      if (!is_new && other->second != &output)
        throw Error(fmt::format("{} and {} would be one file", other->second->name, output.name),
                    output.path.string());
    }
  }
}

std::vector<NamedFile> named(const std::string& name, std::span<const fs::path> paths) {
  std::vector<NamedFile> files;
  for (const fs::path& path : paths) files.push_back({name, path});
  return files;
}

}  // namespace lightbench
