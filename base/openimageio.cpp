#include "base/openimageio.h"

#include <OpenImageIO/imageio.h>

namespace lightbench {
namespace {

constexpr int kMaxImageMegabytes = 4096;  // what kMaxImagePixels pixels of four floats take

}  // namespace

void configure_openimageio() {
  // One decoder thread: as many processes run as there are cores. The limit holds before a reader allocates.
  static const bool configured = OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1) &&
                                 OIIO::attribute("limits:imagesize_MB", kMaxImageMegabytes);
  static_cast<void>(configured);
}

}  // namespace lightbench
