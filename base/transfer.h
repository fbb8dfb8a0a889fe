#pragma once

namespace lightbench {

/// How a file's numbers, 0..1, stand for linear light.
struct Transfer {
  enum class Kind { linear, srgb, power } kind = Kind::linear;
  float exponent = 1;  ///< of `power`: linear light is the number raised to it

  bool operator==(const Transfer&) const = default;
};

/// The linear light of a component.
float decode(const Transfer& transfer, float stored);

}  // namespace lightbench
