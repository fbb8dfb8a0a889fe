#include <set>

#include <gtest/gtest.h>

#include "base/error.h"
#include "renderer/shader_source.h"
#include "renderer/technique.h"

namespace lightbench {
namespace {

TEST(Techniques, NamesAreUnique) {
  std::set<std::string> names;
  for (const Technique& technique : techniques())
    EXPECT_TRUE(names.insert(technique.name).second) << technique.name;
  EXPECT_TRUE(names.contains("direct"));
}

TEST(Techniques, EveryRowIsDocumented) {
  for (const Technique& technique : techniques()) {
    EXPECT_FALSE(technique.doc.empty()) << technique.name;
    for (const ParamSpec& param : technique.params) EXPECT_FALSE(param.doc.empty()) << param.name;
    for (const BufferSpec& buffer : technique.buffers) EXPECT_FALSE(buffer.doc.empty()) << buffer.name;
    EXPECT_NE(technique.render, nullptr);
  }
}

TEST(Techniques, EveryPresetResolves) {
  for (const Technique& technique : techniques()) {
    std::map<std::string, ParamValue> required;
    for (const ParamSpec& param : technique.params)
      if (param.type == ParamType::text) required[param.name] = std::string("x");
    for (const ParamPreset& preset : technique.presets)
      EXPECT_NO_THROW(resolve_params(technique.params, technique.presets, preset.name, required, "test"))
          << technique.name << " " << preset.name;
  }
}

TEST(Techniques, ShaderFilesExist) {
  for (const Technique& technique : techniques())
    for (const std::string& shader : technique.shaders) EXPECT_NO_THROW(shader_source(shader)) << shader;
}

TEST(Techniques, AMisspeltNameIsAnsweredWithTheNearest) {
  try {
    find_technique("dirct", "job.json: $.variants[0]");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("'direct'"), std::string::npos) << error.message();
    EXPECT_EQ(error.where(), "job.json: $.variants[0]");
  }
}

TEST(Techniques, FingerprintFollowsNameVersionAndShaders) {
  Technique technique = find_technique("direct", "test");
  const std::string before = technique_fingerprint(technique);
  EXPECT_EQ(technique_fingerprint(technique), before);
  technique.version += 1;
  EXPECT_NE(technique_fingerprint(technique), before);
  technique.version -= 1;
  technique.shaders.pop_back();
  EXPECT_NE(technique_fingerprint(technique), before);
}

}  // namespace
}  // namespace lightbench
