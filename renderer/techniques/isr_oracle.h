#pragma once

#include <span>

#include "renderer/technique.h"

namespace lightbench {

/// What `isr` with visibility gathers, gathered by exact rays: from surfaces alone that its pictures hold
/// (guard band, layers, additional cameras), but found wherever they are, with exact visibility and shadows,
/// at any resolution. No better search can win more from the same pictures.
Technique isr_oracle_technique();

/// The parameters that it shares with `isr`: what the pictures hold and what is done with the unknown.
std::span<const char* const> isr_oracle_limits();

}  // namespace lightbench
