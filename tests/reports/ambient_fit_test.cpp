#include "reports/ambient_fit.h"

#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "reports/metric.h"

namespace lightbench {
namespace {

/// Values that differ from pixel to pixel, and from component to component.
Image varied(int width, int height, float low, float high) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.data.size(); ++i)
    image.data[i] = low + (high - low) * float((i * 37) % 101) / 100.0f;
  return image;
}

Image lit(const Image& direct, const Image& albedo, const std::array<float, 3>& irradiance) {
  Image image = direct;
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] += albedo.data[i] * irradiance[i % 3];
  return image;
}

TEST(AmbientFit, FindsTheLightThatWasAdded) {
  const Image direct = varied(40, 30, 0, 0.3f);
  const Image albedo = varied(40, 30, 0.2f, 0.9f);
  const AmbientFit fit = fit_ambient(direct, albedo, to_srgb8(lit(direct, albedo, {0.3f, 0.05f, 0})));
  EXPECT_NEAR(fit.irradiance[0], 0.3, 0.003);
  EXPECT_NEAR(fit.irradiance[1], 0.05, 0.0005);
  EXPECT_EQ(fit.irradiance[2], 0);
}

TEST(AmbientFit, IsNoWorseThanTheDirectLight) {
  const Image direct = varied(40, 30, 0.2f, 1.2f);
  const Image albedo = varied(40, 30, 0, 1);
  const Image8 darker = to_srgb8(varied(40, 30, 0, 0.4f));
  const AmbientFit fit = fit_ambient(direct, albedo, darker);
  const Image8 baseline = to_srgb8(direct);
  const auto values = compute_metrics(
      {"ambient_fit", "over_ambient"},
      {.reference = darker, .image = baseline, .baseline = &baseline, .ambient_fit = &fit.image});
  EXPECT_GE(*values.at("ambient_fit").value, 0);
  EXPECT_LE(*values.at("over_ambient").value, 0);
}

TEST(AmbientFit, OfOtherSizesIsAnError) {
  EXPECT_THROW(fit_ambient(Image(4, 3, 3), Image(3, 4, 3), Image8(4, 3, 3)), Error);
  EXPECT_THROW(fit_ambient(Image(4, 3, 3), Image(4, 3, 1), Image8(4, 3, 3)), Error);
}

TEST(AmbientFit, MetricsWithoutItAreUndefined) {
  const Image8 image = to_srgb8(varied(4, 3, 0, 1));
  const auto values =
      compute_metrics({"over_ambient"}, {.reference = image, .image = image, .baseline = &image});
  EXPECT_EQ(values.at("over_ambient"), MetricValue::undefined("the baseline's albedo is not known"));
}

TEST(AmbientFit, IsNotAmongTheDefaultMetrics) {
  EXPECT_TRUE(needs_ambient_fit({"mean_error", "over_ambient"}));
  EXPECT_FALSE(needs_ambient_fit(default_metrics()));
}

}  // namespace
}  // namespace lightbench
