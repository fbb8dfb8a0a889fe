#pragma once

#include "base/params.h"
#include "renderer/direct_light.h"
#include "renderer/surround.h"

namespace lightbench {

class FrameContext;

/// What is gathered from: a surround, lit on both sides of its surfaces.
struct Surroundings {
  GBuffer gbuffer;
  GlTexture surfels;         ///< RGBA32F: planes of the surfaces (techniques/isr/surfels.frag.glsl)
  GlTexture front_radiance;  ///< RGBA16F: what leaves the side that faces the camera, linear
  GlTexture back_radiance;   ///< RGBA16F: and the other side
};

/// Draws and lights the surroundings of the frame's camera with as many bounces as `bounces` asks for less
/// the last one, which `gather_slices` is. Timed as the passes "surround", "shadow map", "direct" and
/// "bounces".
Surroundings draw_surroundings(FrameContext& frame, const ParamValues& params);

/// Indirect light with visibility for the patches that are bound to the units of techniques/isr/coarse.glsl
/// and 8 (normals): RGBA16F, light of a white surface; alpha is the share of directions in which something
/// was seen.
///
/// After Therrien, Levesque and Gilet, "Screen Space Indirect Lighting with Visibility Bitmask" (2023):
/// planes through the camera and the receiver are searched outwards, and what is found covers sectors of
/// directions, of which each has the same part of the cosine-weighted light (Jimenez et al., "Practical
/// Real-Time Strategies for Accurate Indirect Occlusion", 2016, for the integral). Here the search goes by
/// the angle at the camera and may so go all around it; a texel stands for the piece of its surface's plane
/// that the step covers, not for a point; every layer is searched; and both sides of surfaces are told apart.
void gather_slices(FrameContext& frame, const ParamValues& params, const Surroundings& from,
                   const Framebuffer& target);

}  // namespace lightbench
