#include "base/transfer.h"

#include <cmath>

#include "base/color.h"

namespace lightbench {

float decode(const Transfer& transfer, float stored) {
  switch (transfer.kind) {
    case Transfer::Kind::srgb:
      return srgb_decode(stored);
    case Transfer::Kind::power:
      return std::copysign(std::pow(std::abs(stored), transfer.exponent), stored);
    case Transfer::Kind::linear:
      break;
  }
  return stored;
}

}  // namespace lightbench
