#pragma once

#include "renderer/technique.h"

namespace lightbench {

/// The path tracer (renderer/path_tracer.h) as a technique, so that its pictures are scored like any other.
Technique path_tracer_technique();

}  // namespace lightbench
