#include "renderer/radiance/piecewise_file.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "renderer/radiance/baked_file.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

/// One of the four: what it is called, the shape of its entries, and where they are.
template <typename Entry>
struct Part {
  const char* kind;
  int components;
  int bits;
  std::vector<Entry> PiecewiseStack::*entries;
};
constexpr Part<std::uint16_t> kIndices{"mtnc", 1, 16, &PiecewiseStack::color_indices};
constexpr Part<std::uint16_t> kLayers{"mti", 1, 16, &PiecewiseStack::layers};
constexpr Part<Rgb8> kColors{"mtm", 3, 8, &PiecewiseStack::colors};
constexpr Part<std::uint32_t> kFirstSamples{"mtsp", 1, 32, &PiecewiseStack::first_sample};

fs::path file_of(fs::path stem, const char* kind) {
  return stem += fmt::format(".{}", kind);
}

template <typename Entry>
BakedHeader header_of(const PiecewiseStack& stack, const Part<Entry>& part) {
  return {stack.width,
          stack.height,
          stack.grid,
          stack.scale,
          part.components,
          part.bits,
          (stack.*part.entries).size()};
}

template <typename Entry>
BakedFile write_part(const fs::path& stem, const PiecewiseStack& stack, const Part<Entry>& part) {
  return {file_of(stem, part.kind), part.kind, header_of(stack, part),
          std::as_bytes(std::span(stack.*part.entries))};
}

template <typename Entry>
BakedReader open_part(const fs::path& stem, const Part<Entry>& part) {
  BakedReader reader(file_of(stem, part.kind), part.kind);
  reader.expect_entries(part.components, part.bits);
  return reader;
}

void check_same_object(const BakedReader& reader, const BakedReader& other) {
  const BakedHeader &a = reader.header(), &b = other.header();
  if (a.width != b.width || a.height != b.height || a.grid != b.grid || a.scale != b.scale)
    other.fail("is of another object than its ." + std::string(kLayers.kind) + " file");
}

void check_count(const BakedReader& reader, std::uint64_t expected, const char* of_what) {
  if (reader.header().entries != expected)
    reader.fail(fmt::format("has {} entries for {} {}", reader.header().entries, expected, of_what));
}

/// By the headers alone, before anything is allocated.
void check_counts(const BakedReader& layers, const BakedReader& indices, const BakedReader& colors,
                  const BakedReader& first_samples) {
  const std::uint64_t samples = layers.header().entries;
  if (samples > layers.header().values()) layers.fail("has more samples than the object has values");
  check_count(first_samples, layers.header().texels(), "texels");
  if (indices.header().entries == 0) return check_count(colors, samples, "samples without colour indices");
  check_count(indices, samples, "samples");
  if (colors.header().entries > kMaxMappedColors)
    colors.fail(
        fmt::format("has {} colours, an index reaches {}", colors.header().entries, kMaxMappedColors));
}

void check_first_samples(const PiecewiseStack& stack, const BakedReader& reader) {
  const auto& first = stack.first_sample;
  if (first.front() != 0) reader.fail(fmt::format("the first texel starts at sample {}, not at 0", first[0]));
  const auto fall = std::ranges::adjacent_find(first, std::greater_equal());
  if (fall != first.end()) reader.fail(fmt::format("texel {} has no samples", fall - first.begin()));
  if (first.back() >= stack.layers.size())
    reader.fail(fmt::format("the last texel starts at sample {} of {}", first.back(), stack.layers.size()));
}

void check_layers(const PiecewiseStack& stack, const BakedReader& reader) {
  for (std::size_t texel = 0; texel < stack.texels(); ++texel) {
    const std::size_t first = stack.first_sample[texel];
    const auto layers = std::span(stack.layers).subspan(first, stack.samples_end(texel) - first);
    if (layers.front() != 0) reader.fail(fmt::format("texel {} does not start at layer 0", texel));
    if (std::ranges::adjacent_find(layers, std::greater_equal()) != layers.end())
      reader.fail(fmt::format("the layers of texel {} do not rise", texel));
    if (layers.back() >= stack.grid.layers())
      reader.fail(fmt::format("texel {} has layer {} of {}", texel, layers.back(), stack.grid.layers()));
  }
}

void check_indices(const PiecewiseStack& stack, const BakedReader& reader) {
  for (const std::uint16_t index : stack.color_indices)
    if (index >= stack.colors.size())
      reader.fail(fmt::format("has colour index {}, there are {} colours", index, stack.colors.size()));
}

template <typename Entry>
FileSize size_of(const PiecewiseStack& stack, const Part<Entry>& part) {
  return {part.kind, header_of(stack, part).file_bytes()};
}

}  // namespace

void write_piecewise(const fs::path& stem, const PiecewiseStack& stack) {
  std::array files{write_part(stem, stack, kIndices), write_part(stem, stack, kLayers),
                   write_part(stem, stack, kColors), write_part(stem, stack, kFirstSamples)};
  for (BakedFile& file : files) file.commit();
}

PiecewiseStack read_piecewise(const fs::path& stem) {
  BakedReader layers = open_part(stem, kLayers), indices = open_part(stem, kIndices),
              colors = open_part(stem, kColors), first_samples = open_part(stem, kFirstSamples);
  for (const BakedReader* other : {&indices, &colors, &first_samples}) check_same_object(layers, *other);
  check_counts(layers, indices, colors, first_samples);
  const BakedHeader& header = layers.header();
  PiecewiseStack stack{header.width, header.height, header.grid, header.scale, {}, {}, {}, {}};
  stack.layers = layers.read<std::uint16_t>();
  stack.first_sample = first_samples.read<std::uint32_t>();
  check_first_samples(stack, first_samples);
  check_layers(stack, layers);
  stack.color_indices = indices.read<std::uint16_t>();
  stack.colors = colors.read<Rgb8>();
  check_indices(stack, indices);
  return stack;
}

std::vector<FileSize> piecewise_file_sizes(const PiecewiseStack& stack) {
  return {size_of(stack, kIndices), size_of(stack, kLayers), size_of(stack, kColors),
          size_of(stack, kFirstSamples)};
}

}  // namespace lightbench
