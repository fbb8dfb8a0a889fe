#include "base/hash.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sys/stat.h>
#include <xxhash.h>

#include "base/error.h"
#include "base/input_file.h"

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

std::string hash_file(const std::filesystem::path& file, std::uint64_t largest) {
  InputFile input(file, largest);
  Hasher hasher;
  std::array<char, 1 << 16> block;
  std::size_t count = 0;
  do {
    count = input.read(block);
    hasher.field("block", {block.data(), count});
  } while (count == block.size());
  return hasher.digest();
}

std::string file_stamp(const std::filesystem::path& file) {
  struct stat s {};
  if (::stat(file.c_str(), &s) != 0)
    throw Error(fmt::format("cannot read the file: {}", std::strerror(errno)), file.string());
  return fmt::format("{} {} {} {}.{} {}.{}", s.st_dev, s.st_ino, s.st_size, s.st_mtim.tv_sec,
                     s.st_mtim.tv_nsec, s.st_ctim.tv_sec, s.st_ctim.tv_nsec);
}

std::string hash_while_reading(const std::filesystem::path& file, const std::function<void()>& read) {
  std::error_code error;
  const std::string before = std::filesystem::exists(file, error) ? file_stamp(file) : "";
  read();
  std::string hash = hash_file(file);
  if (file_stamp(file) != before) throw Error("was changed while it was read", file.string());
  return hash;
}

}  // namespace lightbench
