#pragma once

#include "renderer/caustics/receiver_map.h"
#include "renderer/gbuffer.h"

namespace lightbench {

class FrameContext;

/// The picture of a scene in water, to which the light of one caustics map after the other is added.
class CausticsPicture {
 public:
  /// `gbuffer` must outlive it and hold the entities.
  CausticsPicture(FrameContext& frame, const GBuffer& gbuffer);

  /// What shows without light through the water; `direct` is the picture of what is above it, empty where
  /// there is nothing.
  void draw_unlit(const GlTexture& direct);
  /// Adds the light of a map (RGBA32F, flux for each unit of area across the axis of the box) on its
  /// receiver, and what the surface makes of it (the water caustics thesis, eq. 4-19 and 4-20).
  void cast(const ReceiverMap& map, const GlTexture& caustics);

  const GlTexture& image() const { return image_; }    ///< RGBA32F
  const GlTexture& landed() const { return landed_; }  ///< RGBA32F: the sum of the maps' flux, unshaded

 private:
  FrameContext& frame_;
  const GBuffer& gbuffer_;
  GlTexture image_, landed_;
};

}  // namespace lightbench
