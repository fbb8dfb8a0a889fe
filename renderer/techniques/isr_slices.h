#pragma once

#include <vector>

#include "renderer/surround.h"
#include "renderer/techniques/isr_frame.h"

namespace lightbench {

/// What is gathered from: a surround, lit on both sides of its surfaces.
struct Surroundings {
  GBuffer gbuffer;
  GlTexture surfels;  ///< RGBA32F: planes of the surfaces (techniques/isr/surfel.glsl)
  /// RGBA16F, twice as high: what leaves the sides that face the camera, linear, and above it the other
  /// sides.
  GlTexture radiance;
  int layers = 1;
};

/// Draws the surroundings of the frame's camera, unlit; timed as the pass "surround".
Surroundings draw_surroundings(FrameContext& frame, const ParamValues& params);
/// How they must be lit directly.
LitPicture lit_picture(const Surroundings& surroundings);
/// Gives them their radiance with that many bounces of indirect light less the last one, which
/// `gather_slices` is; timed as the pass "bounces".
void light_surroundings(FrameContext& frame, const ParamValues& params, const DirectLight& direct,
                        int bounces, Surroundings& surroundings);

/// Indirect light with visibility.
///
/// After Therrien, Levesque and Gilet, "Screen Space Indirect Lighting with Visibility Bitmask" (2023):
/// planes through the camera and the receiver are searched outwards, and what is found covers sectors of
/// directions, of which each has the same part of the cosine-weighted light (Jimenez et al., "Practical
/// Real-Time Strategies for Accurate Indirect Occlusion", 2016, for the integral). Here the search goes by
/// the angle at the camera and may so go all around it; a texel stands for the piece of its surface's plane
/// that the step covers, not for a point; every layer is searched; and both sides of surfaces are told apart.
CoarseLight gather_slices(const Isr& isr, const CoarseScene& coarse, const Surroundings& from);

/// Named buffers that show the surroundings, and what keeps those of them that are wanted.
std::vector<BufferSpec> surround_buffers();
void keep_surround_buffers(FrameContext& frame, const Surroundings& surroundings);

}  // namespace lightbench
