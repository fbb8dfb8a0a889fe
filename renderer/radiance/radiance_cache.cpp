#include "renderer/radiance/radiance_cache.h"

#include <algorithm>
#include <cstdint>

namespace lightbench {
namespace {

// Of files together: 700,000 texels as 16-bit floats in 400 directions, and compressed in some ways beside.
constexpr std::uint64_t kMaxBytes = std::uint64_t{2} << 30;

std::uint64_t bytes_of(const std::list<RadianceObjects>& sets) {
  std::uint64_t bytes = 0;
  for (const RadianceObjects& set : sets) bytes += set.file_bytes();
  return bytes;
}

}  // namespace

const RadianceObjects& RadianceCache::get(const Scene& scene, const std::filesystem::path& folder,
                                          const ParamValues& params) {
  const auto found =
      std::ranges::find_if(kept_, [&](const RadianceObjects& set) { return set.are(folder, params); });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return kept_.front();
  }
  // The new set's files are read into memory too, before the GPU has them.
  const std::uint64_t coming = radiance_file_bytes(scene, folder, params);
  while (!kept_.empty() && bytes_of(kept_) + coming > kMaxBytes) kept_.pop_back();
  return kept_.emplace_front(scene, folder, params);
}

}  // namespace lightbench
