#pragma once

#include "renderer/techniques/isr_frame.h"

namespace lightbench {

/// What samples by depth are given at most, times the mean, and its inverse at least
/// (techniques/isr/samples_share.glsl).
inline constexpr int kMostSamplesShare = 4;

/// Samples by depth without visibility: as many in the mean, so that all kernels fit.
inline constexpr int kMostSamplesByDepth = 128;

/// Samples by depth: what a patch takes goes with its distance from the camera to the power of -exponent.
/// This is the factor that makes the mean over the patches 1. Reads back some sums.
float samples_scale(const Isr& isr, const CoarseScene& coarse);

/// Indirect light without visibility, from samples of the frame around each patch: the thesis's way, see
/// `weighting` and `source`.
CoarseLight gather_samples(const Isr& isr, const CoarseScene& coarse);

}  // namespace lightbench
