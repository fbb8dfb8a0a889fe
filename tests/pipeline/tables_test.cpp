#include "pipeline/tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/references.h"
#include "renderer/technique.h"
#include "reports/metric.h"

namespace lightbench {
namespace {

using ::testing::Contains;

template <typename Rows>
void expect_complete(const Rows& rows) {
  std::set<std::string> names;
  for (const auto& row : rows) {
    EXPECT_FALSE(row.doc.empty()) << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " stands twice";
  }
}

TEST(Tables, EveryRowHasANameOfItsOwnAndSaysWhatItIs) {
  expect_complete(techniques());
  expect_complete(metrics());
  expect_complete(reference_kinds());
  for (const auto& technique : techniques()) expect_complete(technique.params);
  for (const auto& kind : reference_kinds()) expect_complete(kind.params);
}

TEST(Tables, EveryPresetResolves) {
  for (const auto& technique : techniques())
    for (const auto& preset : technique.presets)
      EXPECT_NO_THROW(resolve_params(technique.params, technique.presets, preset.name, {}, ""))
          << preset.name;
  for (const auto& kind : reference_kinds()) {
    EXPECT_THAT(row_names(kind.presets), Contains(kind.default_preset));
    for (const auto& preset : kind.presets)
      EXPECT_NO_THROW(resolve_params(kind.params, kind.presets, preset.name, {}, "")) << preset.name;
  }
}

TEST(Tables, ANameWithBracketsMatchesItself) {
  EXPECT_TRUE(matches_name("isr[samples=24]", "isr[samples=24]"));
  EXPECT_TRUE(matches_name("isr[samples=24]", "isr*"));
  EXPECT_FALSE(matches_name("isr", "direct"));
}

}  // namespace
}  // namespace lightbench
