#pragma once

#include "pipeline/references.h"

namespace lightbench {

ReferenceKind path_tracer_reference();

}  // namespace lightbench
