#pragma once

#include "renderer/technique.h"

namespace lightbench {

/// What `isr` gathers, gathered by exact rays: from those surfaces alone that its pictures hold (guard band,
/// layers, additional cameras), with exact visibility and shadows, at any resolution. It is
/// strict: a ray that first meets any other surface is unknown, while a search may look through that surface
/// and by luck take something better for it than what parameter `unknown` says.
Technique isr_oracle_technique();

/// Its parameters for an `isr` with these: what the pictures hold and what is done with the unknown. Without
/// visibility those are the frame, one bounce and nothing else, whatever the parameters say that only
/// visibility knows.
std::map<std::string, ParamValue> isr_oracle_limits(const ParamValues& isr);

}  // namespace lightbench
