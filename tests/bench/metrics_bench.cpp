// Metrics on a 1024x768 pair, each beside the plainest loop that gives the same number.
#include <cmath>
#include <cstdlib>
#include <random>

#include <benchmark/benchmark.h>

#include "base/color.h"
#include "reports/difference_image.h"
#include "reports/metric.h"

namespace lightbench {
namespace {

Image8 noise(unsigned seed) {
  std::mt19937 generator(seed);
  Image8 image(1024, 768, 3);
  for (auto& value : image.data) value = std::uint8_t(generator() & 255);
  return image;
}

const Image8& first() {
  static const Image8 image = noise(1);
  return image;
}
const Image8& second() {
  static const Image8 image = noise(2);
  return image;
}

void run_metric(benchmark::State& state, const char* name) {
  const Metric& metric = find_metric(name, "");
  const MetricInput input{first(), second()};
  for (auto _ : state) benchmark::DoNotOptimize(metric.compute(input));
  state.SetItemsProcessed(std::int64_t(state.iterations()) * std::int64_t(first().pixel_count()));
}
BENCHMARK_CAPTURE(run_metric, mean_error, "mean_error");
BENCHMARK_CAPTURE(run_metric, pearson, "pearson");
BENCHMARK_CAPTURE(run_metric, luv, "luv");

void plain_mean_error(benchmark::State& state) {
  for (auto _ : state) {
    double sum = 0;
    for (std::size_t i = 0; i < first().data.size(); ++i)
      sum += std::abs(double(first().data[i]) - double(second().data[i]));
    benchmark::DoNotOptimize(sum / double(first().data.size()));
  }
}
BENCHMARK(plain_mean_error);

struct Luv {
  double l, u, v;
};

// CIE 1976 L*u*v* of an sRGB colour for D65, straight from the definition.
Luv luv_of(const std::uint8_t* c) {
  const double r = srgb_decode8(c[0]), g = srgb_decode8(c[1]), b = srgb_decode8(c[2]);
  const double x = 0.4124564 * r + 0.3575761 * g + 0.1804375 * b;
  const double y = 0.2126729 * r + 0.7151522 * g + 0.0721750 * b;
  const double z = 0.0193339 * r + 0.1191920 * g + 0.9503041 * b;
  const double l = y > 216.0 / 24389.0 ? 116 * std::cbrt(y) - 16 : 24389.0 / 27.0 * y;
  const double sum = x + 15 * y + 3 * z;
  if (sum <= 0) return {0, 0, 0};
  return {l, 13 * l * (4 * x / sum - 0.19784), 13 * l * (9 * y / sum - 0.46834)};
}

void plain_luv(benchmark::State& state) {
  for (auto _ : state) {
    double sum = 0;
    for (std::size_t i = 0; i < first().data.size(); i += 3) {
      const Luv a = luv_of(&first().data[i]), b = luv_of(&second().data[i]);
      sum += std::hypot(a.l - b.l, a.u - b.u, a.v - b.v);
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(plain_luv);

void heat_map_image(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(heat_map(first(), second()));
}
BENCHMARK(heat_map_image);

}  // namespace
}  // namespace lightbench
