#include "renderer/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <future>
#include <numeric>

#include <fmt/format.h>
#include <glm/glm.hpp>

#include "base/error.h"
#include "base/image_io.h"
#include "renderer/paths/half_error.h"
#include "renderer/paths/tile_tracer.h"

namespace lightbench {
namespace {

constexpr int kTileSide = 16;         // pixels, without supersampling
constexpr int kTileRays = 32;         // primary rays along a tile's side, at most, unless a pixel has more
constexpr int kFirstHalfSamples = 8;  // of each half, before a tile's noise is first looked at

void check_range(const char* name, double value, double min, double max, const std::string& where) {
  if (!(value >= min && value <= max))
    throw Error(fmt::format("path tracer: {} is {}, not {} to {}", name, value, min, max), where);
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_arguments(const Scene& scene, const View& view, int width, int height, int supersampling,
                     const PathTracerOptions& options) {
  assert(scene.time == view.time);
  check_range("bounces", options.bounces, 0, 16, view.name);
  check_range("samples", options.samples, 2, 65536, view.name);
  check_range("noise", options.noise, 0, 255, view.name);
  check_range("threads", options.threads, 1, 256, view.name);
  check_range("supersampling", supersampling, 1, 64, view.name);
  check_image_size(width, height, view.name);
  check_image_size(static_cast<long long>(width) * supersampling,
                   static_cast<long long>(height) * supersampling, view.name);
  if (triangle_count(scene) == 0)
    throw Error("the scene has no triangles: there is nothing to render", scene.name);
  if (scene.water) throw Error("the path tracer shows no water", scene.name);
  const Camera& camera = view.camera;
  if (!is_finite(camera.position) || !is_finite(camera.look_at) || !is_finite(camera.up) ||
      !(camera.fov > 0 && camera.fov < 3.1415f))
    throw Error("the camera is not finite or its field of view is not an angle below 180 degrees", view.name);
  for (const Light& light : scene.lights)
    if (!is_finite(light.position) || !is_finite(light.direction) || !is_finite(light.color) ||
        !std::isfinite(light.power))
      throw Error("light '" + light.name + "' is not finite", scene.name);
}

/// A pixel as each half of the samples has it, over the background.
struct HalfPixels {
  glm::vec3 half[2];
  float alpha;
  float error() const { return half_error(half[0], half[1]); }
};

struct PixelTile {
  int x, y, width, height;
};

class Picture {
 public:
  Picture(const Scene& scene, const View& view, int width, int height, int supersampling,
          const PathTracerOptions& options)
      : scene_(scene),
        background_(scene.background.color),
        camera_(view.camera, width * supersampling, height * supersampling),
        factor_(supersampling),
        options_(options),
        half_samples_((options.samples + 1) / 2),
        image_(width, height, 4) {
    if (!options.background) scene_.sky = glm::vec3(0);
    if (options.limits) indirect_ = Image(width, height, 3), unknown_ = Image(width, height, 1);
    const int side = std::max(1, std::min(kTileSide, kTileRays / supersampling));
    for (int y = 0; y < height; y += side)
      for (int x = 0; x < width; x += side)
        tiles_.push_back({x, y, std::min(side, width - x), std::min(side, height - y)});
    errors_.resize(tiles_.size());
  }

  PathTracedImage trace();

 private:
  void work(RayTallies& tallies);
  void trace_tile(TileTracer& tracer, std::size_t index);
  HalfPixels pixel(const TileTracer& tracer, const PixelTile& tile, int x, int y) const;
  double error_sum(const TileTracer& tracer, const PixelTile& tile) const;
  void keep_indirect(const TileTracer& tracer, const PixelTile& tile, int x, int y);

  PathScene scene_;
  glm::vec3 background_;
  PathCamera camera_;
  int factor_;
  PathTracerOptions options_;
  int half_samples_;
  Image image_, indirect_, unknown_;
  std::vector<PixelTile> tiles_;
  std::vector<double> errors_;  ///< sums over the pixels of each tile
  std::atomic<std::size_t> next_tile_ = 0;
};

HalfPixels Picture::pixel(const TileTracer& tracer, const PixelTile& tile, int x, int y) const {
  HalfPixels result{};
  for (int j = y * factor_; j < (y + 1) * factor_; ++j)
    for (int i = x * factor_; i < (x + 1) * factor_; ++i) {
      const int ray = j * tile.width * factor_ + i;
      result.alpha += tracer.covered(ray) ? 1.0f : 0.0f;
      for (int half = 0; half < 2; ++half)
        result.half[half] +=
            tracer.covered(ray) ? tracer.direct(ray) + tracer.indirect(ray, half) : background_;
    }
  const float share = 1.0f / float(factor_ * factor_);
  return {{result.half[0] * share, result.half[1] * share}, result.alpha * share};
}

double Picture::error_sum(const TileTracer& tracer, const PixelTile& tile) const {
  double sum = 0;
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) sum += double(pixel(tracer, tile, x, y).error());
  return sum;
}

void Picture::keep_indirect(const TileTracer& tracer, const PixelTile& tile, int x, int y) {
  const float share = 1.0f / float(factor_ * factor_);
  const auto indirect = indirect_.pixel(tile.x + x, tile.y + y);
  const auto unknown = unknown_.pixel(tile.x + x, tile.y + y);
  for (int j = y * factor_; j < (y + 1) * factor_; ++j)
    for (int i = x * factor_; i < (x + 1) * factor_; ++i) {
      const int ray = j * tile.width * factor_ + i;
      const glm::vec3 light = 0.5f * share * (tracer.indirect(ray, 0) + tracer.indirect(ray, 1));
      for (int c = 0; c < 3; ++c) indirect[std::size_t(c)] += light[c];
      unknown[0] += share * tracer.unknown(ray);
    }
}

void Picture::trace_tile(TileTracer& tracer, std::size_t index) {
  const PixelTile& tile = tiles_[index];
  tracer.start({tile.x * factor_, tile.y * factor_, tile.width * factor_, tile.height * factor_});
  const bool adaptive = options_.noise > 0;
  int samples = 0;
  do {
    const int more = samples == 0 ? kFirstHalfSamples : 2 * samples;
    const int target = adaptive ? std::min(more, half_samples_) : half_samples_;
    tracer.add_samples(samples, target);
    samples = target;
    errors_[index] = error_sum(tracer, tile);
  } while (samples < half_samples_ && errors_[index] > options_.noise * tile.width * tile.height);
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) {
      const HalfPixels halves = pixel(tracer, tile, x, y);
      const glm::vec3 color = 0.5f * (halves.half[0] + halves.half[1]);
      const auto target = image_.pixel(tile.x + x, tile.y + y);
      target[0] = color.x, target[1] = color.y, target[2] = color.z, target[3] = halves.alpha;
      if (options_.limits) keep_indirect(tracer, tile, x, y);
    }
}

void Picture::work(RayTallies& tallies) {
  TileTracer tracer(scene_, camera_, options_.bounces, options_.seed, options_.limits);
  for (std::size_t tile = next_tile_++; tile < tiles_.size(); tile = next_tile_++) trace_tile(tracer, tile);
  tallies = tracer.tallies();
}

PathTracedImage Picture::trace() {
  std::vector<RayTallies> tallies(std::size_t(options_.threads));
  std::vector<std::future<void>> helpers;
  for (std::size_t i = 1; i < tallies.size(); ++i)
    helpers.push_back(std::async(std::launch::async, [&, i] { work(tallies[i]); }));
  work(tallies[0]);
  for (std::future<void>& helper : helpers) helper.get();  // with the errors that it met
  RayTallies sum;
  for (const RayTallies& part : tallies) {
    sum.primary += part.primary;
    sum.shadow += part.shadow;
    sum.diffuse += part.diffuse;
    sum.sight += part.sight;
  }
  const double errors = std::accumulate(errors_.begin(), errors_.end(), 0.0);
  const double noise = errors / double(image_.pixel_count());
  std::vector<RayRate> rays{{"primary", sum.primary.rays, sum.primary.seconds},
                            {"shadow", sum.shadow.rays, sum.shadow.seconds},
                            {"diffuse", sum.diffuse.rays, sum.diffuse.seconds}};
  if (options_.limits) rays.push_back({"sight", sum.sight.rays, sum.sight.seconds});
  return {std::move(image_), noise, std::move(rays), std::move(indirect_), std::move(unknown_)};
}

}  // namespace

PathTracedImage trace_paths(const Scene& scene, const View& view, int width, int height, int supersampling,
                            const PathTracerOptions& options) {
  check_arguments(scene, view, width, height, supersampling, options);
  PathTracedImage traced = Picture(scene, view, width, height, supersampling, options).trace();
  if (const auto bad = first_non_finite(traced.image); bad >= 0)
    throw Error(fmt::format("path tracer: pixel ({}, {}) is not a finite number; is every material?",
                            bad / 4 % width, bad / 4 / width),
                scene.name);
  return traced;
}

}  // namespace lightbench
