#include "renderer/renderer.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "base/color.h"
#include "base/error.h"
#include "base/image_io.h"
#include "base/text.h"
#include "renderer/frame_context.h"
#include "renderer/gl_context.h"
#include "renderer/gpu_scene.h"

namespace lightbench {
namespace {

void require_supported(const Technique& technique, const ParamValues& params, const Scene& scene) {
  const std::vector<std::string> reasons = reasons_against(technique, scene, params);
  if (!reasons.empty())
    throw Error(
        fmt::format("technique '{}' cannot render this scene: {}", technique.name, join(reasons, "; ")),
        scene.name);
}

void require_known_buffers(const Technique& technique, const std::set<std::string>& wanted) {
  std::vector<std::string> names;
  for (const BufferSpec& buffer : technique.buffers) names.push_back(buffer.name);
  for (const std::string& name : wanted)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw Error(fmt::format("technique '{}' has no buffer '{}'{}; it has: {}", technique.name, name,
                              did_you_mean(name, names), names.empty() ? "none" : join(names, ", ")));
}

void require_possible_size(const FrameRequest& request) {
  check_image_size(request.width, request.height, request.view.name);
  if (request.samples < 1) throw Error(fmt::format("{} samples", request.samples), request.view.name);
  const long long factor = request.samples;
  check_image_size(factor * request.width, factor * request.height, request.view.name);
}

// A shader that the technique's row does not list would be missing in the keys of its pictures, and an edit
// of it would leave old ones in place.
void require_listed_shaders(const Technique& technique, const std::set<std::string>& used) {
  for (const std::string& shader : used)
    if (std::find(technique.shaders.begin(), technique.shaders.end(), shader) == technique.shaders.end())
      throw std::logic_error(
          fmt::format("technique '{}' draws with {}, which its row does not list", technique.name, shader));
}

// The mean of the samples of each pixel, where the image was drawn larger than the frame.
void average_samples(Image& image, const FrameRequest& request) {
  if (image.width == request.width && image.height == request.height) return;
  image = box_downsample(image, request.samples);
}

}  // namespace

struct Renderer::Impl {
  explicit Impl(GlBackend which) : backend(which) {}

  GlBackend backend;
  std::unique_ptr<GlContext> context;  // outlives what is made in it
  std::unique_ptr<GpuState> gpu;
  std::unique_ptr<GpuScene> scene;
  std::string scene_key;

  ~Impl() {
    if (context) context->make_current();
  }

  void start() {
    if (!context) {
      context = make_gl_context(backend);
      gpu = std::make_unique<GpuState>();
    }
    context->make_current();
    context->forget_complaints();
  }

  void load(const Scene& wanted) {
    const std::string key = gpu_scene_key(wanted);
    if (scene && key == scene_key) return scene->place(wanted);
    scene.reset();  // before the next one takes its memory
    scene = std::make_unique<GpuScene>(wanted);
    scene_key = key;
  }

  void prepare(const FrameRequest& request) {
    start();
    const int limit = context->max_texture_size();
    const long long side = std::max(request.width, request.height);
    if (side * request.samples > limit)
      throw Error(fmt::format("{} x {} pixels at {} samples is too large: OpenGL draws {} pixels a side here",
                              request.width, request.height, request.samples, limit),
                  request.view.name);
    load(request.scene);
    context->check("loading scene " + request.scene.name);
  }
};

Renderer::Renderer(GlBackend backend) : impl_(std::make_unique<Impl>(backend)) {}
Renderer::~Renderer() = default;

FrameResult Renderer::render(const Technique& technique, const ParamValues& params,
                             const FrameRequest& request) {
  assert(request.scene.time == request.view.time);
  require_possible_size(request);
  require_known_buffers(technique, request.buffers);
  require_supported(technique, params, request.scene);
  if (technique.needs_gl) impl_->prepare(request);
  FrameContext frame(request, impl_->gpu.get(), impl_->scene.get());
  technique.render(frame, params);
  if (technique.needs_gl) impl_->context->check(technique.name);
  require_listed_shaders(technique, frame.used_shaders());
  FrameResult result = std::move(frame.result());
  average_samples(result.image, request);
  for (auto& [name, image] : result.buffers) average_samples(image, request);
  return result;
}

std::string Renderer::description() {
  impl_->start();
  return impl_->context->description();
}

}  // namespace lightbench
