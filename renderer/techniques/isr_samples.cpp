#include "renderer/techniques/isr_samples.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/vec4.hpp>

#include "renderer/techniques/isr_kernel.h"

namespace lightbench {
namespace {

constexpr unsigned kFarPatchUnit = 9;  // of techniques/isr/gather.frag.glsl
constexpr unsigned kFarRadianceUnit = 10;
constexpr unsigned kKernelBinding = 1;
constexpr int kSummedBlock = 32;  // patches along the edge of the blocks that one invocation sums up

/// Whether the background is gathered: black is not worth the work.
bool gathers_background(const Isr& isr) {
  const Background& background = isr.frame.scene().background;
  return isr.params.boolean("background") && background.lights && background.color != glm::vec3(0);
}

/// The frame in larger blocks still, for samples that stand for much of it.
struct FarScene {
  GlTexture patches;
  GlTexture radiance;
};

/// Pixels along the edge of those blocks. Eq. 25 knows no other patch than the pixel.
int far_block(const Isr& isr) {
  return isr.is("weighting", "paper") ? 1 : isr.params.integer("far_block");
}

FarScene reduce(const Isr& isr, const CoarseScene& coarse) {
  const int block = far_block(isr);
  if (block == 1) return {};
  const glm::ivec2 size = (isr.coarse_size + block - 1) / block;
  FarScene far{GlTexture(TexelFormat::rgba32f, size.x, size.y),
               GlTexture(TexelFormat::rgba16f, size.x, size.y)};
  const Program& program = isr.program("reduce");
  program.set("block", block);
  coarse.patches.bind(kPatchUnit);
  coarse.radiance.bind(kCoarseRadianceUnit);
  isr.frame.draw_fullscreen(Framebuffer({&far.patches, &far.radiance}), program);
  return far;
}

using Kernel = std::vector<KernelSample>;

Kernel make_kernel(const Isr& isr, int samples) {
  if (isr.is("pattern", "grid")) return grid_kernel(samples, isr.number("spacing"));
  const float radius = isr.number("radius") * float(isr.coarse_size.x);
  const bool jittered = isr.is("pattern", "jittered");
  return (jittered ? jittered_kernel : spiral_kernel)(samples, radius, isr.number("spread"));
}

/// One kernel, or those that samples by depth choose from: 1/4 to 4 times the samples.
std::vector<Kernel> make_kernels(const Isr& isr) {
  const int samples = isr.params.integer("samples");
  if (isr.number("samples_by_depth") == 0) return {make_kernel(isr, samples)};
  std::vector<Kernel> kernels;
  for (int level = 0; level < kMaxKernelLevels; ++level)
    kernels.push_back(make_kernel(isr, std::max((samples << level) / kMostSamplesShare, 1)));
  return kernels;
}

/// The block Kernel of techniques/isr/gather.frag.glsl, std140.
struct KernelBlock {
  std::array<glm::vec4, kMaxKernelSamples> samples{};
  std::array<glm::ivec4, kMaxKernelLevels> levels{};
};

static_assert(sizeof(KernelBlock) <= 16384);  // what every OpenGL has room for

/// Shares are on the image plane at distance 1, divided by pi; `pixel_size` is the edge of a coarse pixel
/// there.
Buffer kernel_block(const Isr& isr, const std::vector<Kernel>& kernels, float pixel_size) {
  auto block = std::make_unique<KernelBlock>();
  const bool paper = isr.is("weighting", "paper");
  int count = 0;
  for (std::size_t level = 0; level < kernels.size(); ++level) {
    const Kernel& kernel = kernels[level];
    block->levels[level] =
        glm::ivec4(count, count + near_samples(kernel, far_block(isr)), count + int(kernel.size()), 0);
    for (const KernelSample& sample : kernel) {
      const float area = paper ? 1.0f : sample.area;  // eq. 25 takes one pixel as the patch
      block->samples[std::size_t(count++)] =
          glm::vec4(sample.offset, area * pixel_size * pixel_size / glm::pi<float>(), 0);
    }
  }
  return Buffer(block.get(), sizeof *block);
}

ShaderDefines gather_defines(const Isr& isr) {
  ShaderDefines defines;
  if (gathers_background(isr)) defines.push_back("BACKGROUND");
  if (far_block(isr) > 1) defines.push_back("FAR_BLOCK " + std::to_string(far_block(isr)));
  if (isr.number("samples_by_depth") > 0) defines.push_back("SAMPLES_BY_DEPTH");
  return defines;
}

}  // namespace

float samples_scale(const Isr& isr, const CoarseScene& coarse) {
  const glm::ivec2 size = (isr.coarse_size + kSummedBlock - 1) / kSummedBlock;
  const GlTexture blocks(TexelFormat::rg32f, size.x, size.y);
  const Program& program = isr.program("depth_sum");
  program.set("block", kSummedBlock);
  program.set("exponent", isr.number("samples_by_depth"));
  coarse.patches.bind(kPatchUnit);
  isr.frame.draw_fullscreen(Framebuffer({&blocks}), program);
  glm::dvec2 sum(0);
  const Image sums = read_back(blocks, 2);
  for (std::size_t i = 0; i < sums.data.size(); i += 2) sum += glm::dvec2(sums.data[i], sums.data[i + 1]);
  return sum.x > 0 ? float(sum.y / sum.x) : 1.0f;
}

CoarseLight gather_samples(const Isr& isr, const CoarseScene& coarse) {
  const FarScene far = reduce(isr, coarse);
  // Edge of a coarse pixel at distance 1.
  const float pixel_size = 2 * isr.gbuffer.camera.tan_half_y * float(isr.block()) / float(isr.gbuffer.height);
  const std::vector<Kernel> kernels = make_kernels(isr);
  const Buffer block = kernel_block(isr, kernels, pixel_size);
  CoarseLight light = make_light(isr);
  const bool by_depth = kernels.size() > 1;
  const float scale = by_depth ? samples_scale(isr, coarse) : 1;
  const Program& program = isr.program("gather", gather_defines(isr));
  program.set("depth_exponent", isr.number("samples_by_depth"));
  program.set("depth_scale", scale);
  program.set("coarse_texel", float(isr.block()) / glm::vec2(isr.gbuffer.width, isr.gbuffer.height));
  program.set("form_factor_limit", isr.number("form_factor_limit"));
  program.set("background", isr.frame.scene().background.color);
  program.set("occluder_radius", isr.number("occluder_radius") * pixel_size / float(isr.block()));
  program.set("occlusion_scale",
              isr.number("occlusion_radius") * float(isr.coarse_size.x) / kernel_reach(kernels.front()));
  isr.gbuffer.camera_block.bind_uniform(0);
  block.bind_uniform(kKernelBinding);
  coarse.patches.bind(kPatchUnit);
  coarse.radiance.bind(kCoarseRadianceUnit);
  coarse.normals.bind(kCoarseNormalUnit);
  if (far.patches.id() != 0) {
    far.patches.bind(kFarPatchUnit);
    far.radiance.bind(kFarRadianceUnit);
  }
  isr.frame.draw_fullscreen(target_of(light), program);
  return light;
}

}  // namespace lightbench
