// Piecewise compression of a shiny wall: time, and what it saves by direction order, rule and threshold.
#include <benchmark/benchmark.h>

#include "renderer/radiance/codec_report.h"
#include "renderer/radiance/piecewise_encoder.h"
#include "renderer/radiance/piecewise_file.h"
#include "tests/renderer/radiance/synthetic_wall.h"

namespace lightbench {
namespace {

ByteStack wall_in_order(LayerOrder order) {
  return to_bytes(make_stack({.grid = {20, 20, order}}));
}

void count_values(benchmark::State& state, const ByteStack& wall) {
  state.SetItemsProcessed(std::int64_t(state.iterations()) * std::int64_t(wall.texels.size()));
}

// Arguments: layer order, rule, threshold.
void encode_wall(benchmark::State& state) {
  const ByteStack wall = wall_in_order(LayerOrder(state.range(0)));
  const auto rule = SampleRule(state.range(1));
  const int threshold = int(state.range(2));
  for (auto _ : state) benchmark::DoNotOptimize(encode_piecewise(wall, rule, threshold));
  count_values(state, wall);
  const PiecewiseStack encoded = encode_piecewise(wall, rule, threshold);
  const CodecReport report = report_codec(wall, decode_piecewise(encoded), piecewise_file_sizes(encoded));
  state.SetLabel(name_of(wall.grid.order));
  state.counters["ratio"] = report.ratio;
  state.counters["mean_changed_error"] = report.mean_changed_error;
  state.counters["max_error"] = report.max_error;
  state.counters["samples_per_texel"] = double(encoded.layers.size()) / double(encoded.texels());
}
BENCHMARK(encode_wall)->ArgsProduct({{0, 1, 2}, {0, 1}, {0, 6, 9}})->Unit(benchmark::kMillisecond);

void decode_wall(benchmark::State& state) {
  const ByteStack wall = wall_in_order(LayerOrder::phi_serpentine);
  const PiecewiseStack encoded = encode_piecewise(wall, SampleRule::greedy, int(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(decode_piecewise(encoded));
  count_values(state, wall);
}
BENCHMARK(decode_wall)->Arg(0)->Arg(6)->Unit(benchmark::kMillisecond);

// Any texel in any direction, as a fragment shader asks for it.
void decode_value(benchmark::State& state) {
  const PiecewiseStack encoded =
      encode_piecewise(wall_in_order(LayerOrder::phi_serpentine), SampleRule::greedy, 6);
  std::size_t i = 0;
  for (auto _ : state) {
    i = i * 6364136223846793005u + 1442695040888963407u;
    benchmark::DoNotOptimize(decode_piecewise(encoded, (i >> 33) % encoded.texels(), int((i >> 20) % 400)));
  }
  state.SetItemsProcessed(std::int64_t(state.iterations()));
}
BENCHMARK(decode_value);

}  // namespace
}  // namespace lightbench
