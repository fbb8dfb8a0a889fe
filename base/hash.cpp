#include "base/hash.h"

#include <array>
#include <fstream>

#include <fmt/format.h>
#include <xxhash.h>

#include "base/error.h"

namespace lightbench {

struct Hasher::State {
  XXH3_state_t* xxh = XXH3_createState();
  State() { XXH3_128bits_reset(xxh); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { XXH3_freeState(xxh); }

  void add(std::string_view bytes) {
    const std::uint64_t length = bytes.size();
    XXH3_128bits_update(xxh, &length, sizeof length);
    XXH3_128bits_update(xxh, bytes.data(), bytes.size());
  }
};

Hasher::Hasher() : state_(std::make_unique<State>()) {}
Hasher::Hasher(Hasher&&) noexcept = default;
Hasher& Hasher::operator=(Hasher&&) noexcept = default;
Hasher::~Hasher() = default;

Hasher& Hasher::field(std::string_view name, std::string_view bytes) {
  state_->add(name);
  state_->add(bytes);
  return *this;
}

Hasher& Hasher::field(std::string_view name, std::int64_t value) {
  return field(name, std::to_string(value));
}

std::string Hasher::digest() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_->xxh);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string hash_bytes(std::string_view bytes) {
  return Hasher().field("bytes", bytes).digest();
}

std::string hash_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("cannot read the file", file.string());
  Hasher hasher;
  std::array<char, 1 << 16> block;
  do {
    stream.read(block.data(), block.size());
    hasher.field("block", {block.data(), std::size_t(stream.gcount())});
  } while (stream);
  if (stream.bad()) throw Error("cannot read the file", file.string());
  return hasher.digest();
}

}  // namespace lightbench
