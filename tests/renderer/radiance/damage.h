#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

/// Ways to damage the header that all files of a baked object share.
namespace lightbench {

template <typename T>
std::string with_field(std::string bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

/// Without waiting for the disk.
inline void overwrite(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::remove(file);  // some file systems wait when a file is emptied and written anew
  std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

struct Damage {
  const char* what;
  std::string bytes;
};

/// `bytes` are those of a file of the texture of a few texels.
inline std::vector<Damage> damaged_headers(const std::string& bytes) {
  std::vector<Damage> all{{"magic", with_field<std::uint8_t>(bytes, 3, 'x')},
                          {"kind", with_field<std::uint8_t>(bytes, 7, 'x')},
                          {"version 0", with_field<std::uint32_t>(bytes, 8, 0)},
                          {"version 2", with_field<std::uint32_t>(bytes, 8, 2)},
                          {"components", with_field<std::uint16_t>(bytes, 36, 2)},
                          {"no components", with_field<std::uint16_t>(bytes, 36, 0)},
                          {"bits", with_field<std::uint16_t>(bytes, 38, 12)},
                          {"no bits", with_field<std::uint16_t>(bytes, 38, 0)},
                          {"order", with_field<std::uint32_t>(bytes, 32, 3)},
                          {"scale 0", with_field<float>(bytes, 40, 0.0f)},
                          {"scale -1", with_field<float>(bytes, 40, -1.0f)},
                          {"scale inf", with_field<std::uint32_t>(bytes, 40, 0x7f800000)},
                          {"scale nan", with_field<std::uint32_t>(bytes, 40, 0x7fc00000)}};
  // Width, height, depth, thetas, phis, number of entries.
  for (const std::size_t at : {12u, 16u, 20u, 24u, 28u, 44u})
    for (const std::uint32_t value :
         {0u, 1u, 7u, 255u, 16384u, 16385u, 65536u, 0x7fffffffu, 0x80000000u, 0xffffffffu})
      if (std::string other = with_field(bytes, at, value); other != bytes) all.push_back({"a size", other});
  return all;
}

}  // namespace lightbench
