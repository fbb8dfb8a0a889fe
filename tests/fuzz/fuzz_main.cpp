#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/error.h"
#include "fuzz_targets.h"

/// The program of all targets: `lightbench_fuzz --target=obj [OPTION OF libFuzzer ...] [CORPUS ...]`, and
/// `lightbench_fuzz --list` for their names and dictionaries. libFuzzer leaves options that start with -- to
/// us.
namespace lightbench::fuzz {
namespace {

const FuzzTarget* chosen = nullptr;

void list() {
  for (const FuzzTarget& target : fuzz_targets()) std::printf("%s %s\n", target.name, target.dictionary);
}

void read_argument(std::string_view argument) {
  constexpr std::string_view kTarget = "--target=";
  if (argument.starts_with(kTarget)) chosen = &find_fuzz_target(std::string(argument.substr(kTarget.size())));
  if (argument != "--list") return;
  list();
  std::exit(0);
}

}  // namespace
}  // namespace lightbench::fuzz

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) try {
  for (int i = 1; i < *argc; ++i) lightbench::fuzz::read_argument((*argv)[i]);
  if (!lightbench::fuzz::chosen) throw lightbench::Error("is missing", "--target");
  return 0;
} catch (const lightbench::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  std::exit(3);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lightbench::fuzz::is_read(*lightbench::fuzz::chosen, {reinterpret_cast<const char*>(data), size});
  return 0;
}
