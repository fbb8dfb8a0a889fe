#pragma once

#include "renderer/technique.h"

namespace lightbench {

/// Image-space radiosity: indirect light gathered in screen space from the lit picture itself, and ambient
/// occlusion, after sections 4.2 to 4.5 of the image-space radiosity thesis.
///
/// Weighting `paper` is its eq. 25, downsampling `mean` its section 4.2, upsampling `depth` its eq. 27;
/// preset `paper` takes all three. Weighting `area` (default) gives the same sum its physical scale: the
/// indirect light of a white surface at P is (1/pi) times the sum over samples X of L_X cos_P cos_X dA_X /
/// |PX|^2, where dA_X is the surface that the sample's share of the kernel covers, a z_X^2 / |n_X . v_X| with
/// a the share's area on the image plane at distance 1 and v_X the ray through the sample with unit length
/// along the camera's axis. The samples lie densely around P and thinly far off, in proportion to what a
/// share there can contribute, so that no weight needs to be bounded and the sum stays without bias. What the
/// camera does not see is not gathered, and what stands between P and X is not looked for: that is what
/// visibility `bitmask` is for (isr_slices.h).
Technique isr_technique();

}  // namespace lightbench
