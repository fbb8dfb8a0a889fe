# Warnings, sanitizers and the instruction set, as one interface target that only our own code links privately.
include(CheckCXXSourceRuns)

# x86-64-v3 (AVX2, FMA) where this machine can run it, else the compiler's default.
set(CMAKE_REQUIRED_FLAGS "-march=x86-64-v3")
check_cxx_source_runs("
  #include <immintrin.h>
  int main(int argc, char**) {
    __m256 x = _mm256_set1_ps(static_cast<float>(argc));
    x = _mm256_fmadd_ps(x, x, x);
    return _mm256_cvtss_f32(x) > 0.0f ? 0 : 1;
  }" LIGHTBENCH_RUNS_X86_64_V3)
unset(CMAKE_REQUIRED_FLAGS)
if(LIGHTBENCH_RUNS_X86_64_V3)
  set(LIGHTBENCH_MARCH "x86-64-v3")
else()
  set(LIGHTBENCH_MARCH "default")
endif()

add_library(lightbench_options INTERFACE)
target_include_directories(lightbench_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(lightbench_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align
  $<$<BOOL:${LIGHTBENCH_RUNS_X86_64_V3}>:-march=x86-64-v3>)

find_program(LIGHTBENCH_MOLD mold)
if(LIGHTBENCH_MOLD)
  target_link_options(lightbench_options INTERFACE -fuse-ld=mold)
endif()

if(LIGHTBENCH_SANITIZE)
  add_compile_options(-fsanitize=${LIGHTBENCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${LIGHTBENCH_SANITIZE})
endif()
