#pragma once

#include <string_view>

namespace lightbench {

/// Whether a JPEG file reaches its end-of-image marker. Decoders fill with grey what is missing and say
/// nothing.
bool reaches_jpeg_end(std::string_view bytes);

}  // namespace lightbench
