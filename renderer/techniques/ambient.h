#pragma once

#include "renderer/technique.h"

namespace lightbench {

/// Direct lighting and a constant ambient light: albedo * k * mean direct irradiance over the pixels that
/// show an object. The baseline that any indirect lighting has to beat.
Technique ambient_technique();

}  // namespace lightbench
