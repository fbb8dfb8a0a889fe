#include "pipeline/input_hashes.h"

#include "base/hash.h"

namespace lightbench {

std::string InputHashes::hash(const std::filesystem::path& file) {
  const std::string stamp = file_stamp(file);
  Known& known = known_[file];
  if (known.stamp != stamp) known = {stamp, hash_file(file)};
  return known.hash;
}

}  // namespace lightbench
