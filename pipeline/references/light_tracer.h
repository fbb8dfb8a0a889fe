#pragma once

#include "pipeline/references.h"

namespace lightbench {

ReferenceKind light_tracer_reference();

}  // namespace lightbench
