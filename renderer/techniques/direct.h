#pragma once

#include "renderer/technique.h"

namespace lightbench {

/// Deferred direct lighting with shadow maps: what the other techniques start from.
Technique direct_technique();

}  // namespace lightbench
