#pragma once

#include "pipeline/references.h"

namespace lightbench {

ReferenceKind povray_reference();

}  // namespace lightbench
