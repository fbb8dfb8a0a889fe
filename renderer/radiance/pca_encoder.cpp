#include "renderer/radiance/pca_encoder.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "renderer/radiance/pca_corrections.h"
#include "renderer/radiance/pca_fit.h"
#include "renderer/radiance/pca_quantizer.h"
#include "renderer/radiance/pca_sample.h"
#include "renderer/radiance/texel_values.h"

namespace lightbench {
namespace {

using Eigen::Index;
using Eigen::MatrixXf;

constexpr std::size_t kSampleBlocks = 512;  // twice as many do not lower the error

TexelPlaces counted_places(const HalfStack& stack, std::span<const std::uint8_t> counts) {
  TexelPlaces places;
  for (std::size_t i = 0; i < stack.layer_size(); ++i)
    if (counts.empty() || counts[i] != 0) places.push_back(std::uint32_t(i));
  return places;
}

bool is_matte(const HalfStack& stack, const TexelPlaces& places) {
  for (int layer = 1; layer < stack.grid.layers(); ++layer) {
    const auto* const texels = stack.texels.data() + std::size_t(layer) * stack.layer_size();
    for (const std::uint32_t place : places)
      if (texels[place] != stack.texels[place]) return false;
  }
  return true;
}

MatrixXf all_coefficients(const HalfStack& stack, const TexelPlaces& places, const PcaAxes& axes) {
  MatrixXf result(axes.vectors.cols(), Index(places.size()));
  for_texel_blocks(stack, places, [&](std::size_t first, auto block, const MatrixXf& values) {
    result.middleCols(Index(first), Index(block.size())) = axes.coefficients(values);
  });
  return result;
}

/// Encodes an object with one number of coefficients after another, first a sample of its texels.
class Encoder {
 public:
  Encoder(const HalfStack& stack, const TexelPlaces& places, const PcaOptions& options)
      : stack_(stack),
        places_(places),
        options_(options),
        sample_(sample_blocks(stack, places, kSampleBlocks)),
        fit_(texel_values(sample_.stack, sample_.places)) {}

  PcaStack encode_within();
  PcaStack encode_bounded();

 private:
  PcaStack encoded(const HalfStack& stack, const TexelPlaces& places, const PcaAxes& axes, int count) const;
  bool reaches(const HalfStack& stack, const TexelPlaces& places, const PcaStack& pca) const;
  double bytes_of_all(const PcaStack& sample) const;

  const HalfStack& stack_;
  const TexelPlaces& places_;
  const PcaOptions& options_;
  PcaSample sample_;
  PcaFit fit_;
};

PcaStack Encoder::encoded(const HalfStack& stack, const TexelPlaces& places, const PcaAxes& axes,
                          int count) const {
  const PcaLayout layout{options_.first_bits == 16 ? 4u : 0u, options_.first_bits == 16 ? 0u : 4u,
                         std::size_t(count - 4)};
  return quantized(stack, places, axes, all_coefficients(stack, places, axes), layout);
}

bool Encoder::reaches(const HalfStack& stack, const TexelPlaces& places, const PcaStack& pca) const {
  const PcaErrors errors = measure_pca(stack, places, pca);
  return errors.mean_changed <= options_.mean_error && errors.error_99 <= options_.error_99;
}

/// The least number with which the sample, and then the whole object, keeps the errors.
PcaStack Encoder::encode_within() {
  for (int count = 4;; count += 2) {
    const PcaAxes axes = fit_.grow(count);
    const bool last = count + 2 > options_.max_coefficients;
    const bool promising =
        reaches(sample_.stack, sample_.places, encoded(sample_.stack, sample_.places, axes, count));
    if (!promising && !last) continue;
    PcaStack pca = encoded(stack_, places_, axes, count);
    if (last || reaches(stack_, places_, pca)) return pca;
  }
}

/// What the object takes if its texels are like the sample's.
double Encoder::bytes_of_all(const PcaStack& sample) const {
  const double basis = double(2 * (sample.mean.size() + sample.basis.size()));
  return basis + (double(sample.bytes()) - basis) * double(stack_.layer_size()) / double(sample.texels());
}

/// The number with which records and corrections together take the fewest bytes.
PcaStack Encoder::encode_bounded() {
  double least = std::numeric_limits<double>::infinity();
  PcaAxes best;
  int best_count = 0;
  for (int count = 4; count <= options_.max_coefficients; count += 2) {
    const PcaAxes axes = fit_.grow(count);
    PcaStack pca = encoded(sample_.stack, sample_.places, axes, count);
    if (bytes_of_all(pca) >= least) break;
    add_corrections(sample_.stack, sample_.places, options_.threshold, pca);
    if (bytes_of_all(pca) < least) least = bytes_of_all(pca), best = axes, best_count = count;
  }
  PcaStack pca = encoded(stack_, places_, best, best_count);
  add_corrections(stack_, places_, options_.threshold, pca);
  return pca;
}

}  // namespace

PcaStack encode_pca(const HalfStack& stack, std::span<const std::uint8_t> counts, const PcaOptions& options) {
  assert(options.max_coefficients >= 4 && options.max_coefficients <= 64 &&
         options.max_coefficients % 2 == 0);
  assert(options.first_bits == 8 || options.first_bits == 16);
  assert(counts.empty() || counts.size() == stack.layer_size());
  const TexelPlaces places = counted_places(stack, counts);
  if (is_matte(stack, places)) return matte_pca(stack, places);
  Encoder encoder(stack, places, options);
  return options.threshold > 0 ? encoder.encode_bounded() : encoder.encode_within();
}

}  // namespace lightbench
