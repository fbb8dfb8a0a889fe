#include "reports/metrics/luv.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/color.h"

namespace lightbench {
namespace {

/// Linear sRGB to XYZ (IEC 61966-2-1), and what CIE 1976 u' v' need of it: u' = 4 X / D, v' = 9 Y / D with
/// D = X + 15 Y + 3 Z. The white point is the matrix's own white, so that greys have u* = v* = 0.
struct Weights {
  double red, green, blue;
  constexpr double white() const { return red + green + blue; }
};
constexpr Weights kX{0.4124564, 0.3575761, 0.1804375};
constexpr Weights kY{0.2126729, 0.7151522, 0.0721750};
constexpr Weights kZ{0.0193339, 0.1191920, 0.9503041};
constexpr Weights kD{kX.red + 15 * kY.red + 3 * kZ.red, kX.green + 15 * kY.green + 3 * kZ.green,
                     kX.blue + 15 * kY.blue + 3 * kZ.blue};
constexpr double kWhiteU = 4 * kX.white() / kD.white();
constexpr double kWhiteV = 9 * kY.white() / kD.white();
/// Below this Y / Y_n, L* is linear: (6/29)^3 and (29/3)^3.
constexpr double kLinearEnd = 216.0 / 24389.0;
constexpr double kLinearSlope = 24389.0 / 27.0;

constexpr std::size_t kBlock = 256;

struct LuvBlock {
  std::array<float, kBlock> l, u, v;
};

/// Two Halley steps from a guess made by dividing the exponent by 3; exact to float rounding for normal y >
/// 0. Unlike std::cbrt it can be vectorised.
inline float cube_root(float y) {
  const auto step = [y](float x) {
    const float cube = x * x * x;
    return x * (cube + 2 * y) / (2 * cube + y);
  };
  return step(step(std::bit_cast<float>(std::bit_cast<std::uint32_t>(y) / 3 + 709921077u)));
}

const std::array<float, 256>& linear_values() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = srgb_decode8(std::uint8_t(i));
    return values;
  }();
  return table;
}

inline float dot(const Weights& weights, float red, float green, float blue) {
  return float(weights.red) * red + float(weights.green) * green + float(weights.blue) * blue;
}

/// In two loops: looking values up is scalar work, and the arithmetic on them is vectorised.
void convert(const std::uint8_t* rgb, std::size_t count, const float* linear, LuvBlock& out) {
  std::array<float, kBlock> reds, greens, blues;
  for (std::size_t i = 0; i < count; ++i) {
    reds[i] = linear[rgb[3 * i]];
    greens[i] = linear[rgb[3 * i + 1]];
    blues[i] = linear[rgb[3 * i + 2]];
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float red = reds[i], green = greens[i], blue = blues[i];
    const float y = dot(kY, red, green, blue) / float(kY.white());
    // Black has L* = 0, which makes u* and v* 0 whatever its chromaticity; it only must not be 0 / 0.
    const float d = dot(kD, red, green, blue);
    const float inverse_d = 1.0f / (d > 1e-20f ? d : 1e-20f);
    const float end = float(kLinearEnd);
    const float curved = 116.0f * cube_root(y > end ? y : end) - 16.0f;
    const float straight = float(kLinearSlope) * y;
    const float l = y > end ? curved : straight;
    out.l[i] = l;
    out.u[i] = 13.0f * l * (4.0f * dot(kX, red, green, blue) * inverse_d - float(kWhiteU));
    out.v[i] = 13.0f * l * (9.0f * dot(kY, red, green, blue) * inverse_d - float(kWhiteV));
  }
}

/// Distances as whole multiples of 2^-20 (cut, which is below single precision), so that their sum does not
/// depend on the order of adding.
constexpr float kUnit = 1 << 20;

void distances(const LuvBlock& a, const LuvBlock& b, std::size_t count, std::int32_t* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const float l = a.l[i] - b.l[i], u = a.u[i] - b.u[i], v = a.v[i] - b.v[i];
    const float units = std::sqrt(l * l + u * u + v * v) * kUnit;
    out[i] = std::int32_t(units);
  }
}

/// Adds the distances where the mask, if any, is not zero; returns their number.
std::size_t add_up(const std::int32_t* distance, const std::uint8_t* mask, std::size_t count,
                   std::int64_t& total) {
  std::int64_t sum = 0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool counts = !mask || mask[i] != 0;
    sum += counts ? distance[i] : 0;
    counted += counts;
  }
  total += sum;
  return counted;
}

}  // namespace

MetricValue luv(const MetricInput& input) {
  const std::size_t pixels = input.reference.pixel_count();
  const float* linear = linear_values().data();
  LuvBlock a, b;
  std::array<std::int32_t, kBlock> distance;
  std::int64_t total = 0;
  std::size_t counted = 0;
  for (std::size_t begin = 0; begin < pixels; begin += kBlock) {
    const std::size_t count = std::min(kBlock, pixels - begin);
    convert(input.reference.data.data() + 3 * begin, count, linear, a);
    convert(input.image.data.data() + 3 * begin, count, linear, b);
    distances(a, b, count, distance.data());
    counted += add_up(distance.data(), input.mask ? input.mask->data() + begin : nullptr, count, total);
  }
  if (counted == 0) return MetricValue::undefined("the mask is empty");
  return MetricValue::of(double(total) / double(kUnit) / double(counted));
}

Luv to_luv(std::uint8_t red8, std::uint8_t green8, std::uint8_t blue8) {
  const double red = srgb_decode8(red8), green = srgb_decode8(green8), blue = srgb_decode8(blue8);
  const auto sum = [&](const Weights& w) { return w.red * red + w.green * green + w.blue * blue; };
  const double y = sum(kY) / kY.white();
  const double d = sum(kD);
  if (d <= 0) return {};
  const double l = y > kLinearEnd ? 116 * std::cbrt(y) - 16 : kLinearSlope * y;
  return {l, 13 * l * (4 * sum(kX) / d - kWhiteU), 13 * l * (9 * sum(kY) / d - kWhiteV)};
}

}  // namespace lightbench
