#pragma once

#include <span>

#include "renderer/technique.h"

namespace lightbench {

/// What `isr` with visibility gathers, gathered by exact rays: from those surfaces alone that its pictures
/// hold (guard band, layers, additional cameras), with exact visibility and shadows, at any resolution. It is
/// strict: a ray that first meets any other surface is unknown, while a search may look through that surface
/// and by luck take something better for it than what parameter `unknown` says.
Technique isr_oracle_technique();

/// The parameters that it shares with `isr`: what the pictures hold and what is done with the unknown.
std::span<const char* const> isr_oracle_limits();

}  // namespace lightbench
