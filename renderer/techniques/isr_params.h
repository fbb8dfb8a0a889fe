#pragma once

#include <string>
#include <vector>

#include "base/params.h"

namespace lightbench {

inline constexpr int kMaxBounces = 4;

/// Parameters and presets of image-space radiosity, those of the shadows at the end.
std::vector<ParamSpec> isr_params();
std::vector<ParamPreset> isr_presets();

/// What the shaders in techniques/isr are compiled with: NAME_CHOICE in capitals, such as WEIGHTING_AREA.
std::vector<std::string> isr_defines(const ParamValues& params);

}  // namespace lightbench
