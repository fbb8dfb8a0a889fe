#include "renderer/radiance/pca_codec.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/files.h"
#include "renderer/radiance/object_bake.h"
#include "renderer/techniques/surface_radiance.h"
#include "tests/renderer/room_scenes.h"

namespace lightbench {
namespace {

using namespace test;

ParamValues bounded(long long bound) {
  const Technique technique = surface_radiance_technique();
  return resolve_params(
      technique.params, technique.presets, "",
      {{"codec", std::string("pca")}, {"bound", bound}, {"texels", 3e3}, {"thetas", 10LL}, {"phis", 10LL}},
      "");
}

TEST(PcaCodec, KeepsABoundOfBakedSurfaces) {
  Scene scene = room();
  for (Material& material : scene.materials) material.specular = 0.5f, material.exponent = 30;
  const ObjectBaker baker(scene);
  const TemporaryFolder folder;
  for (const std::size_t entity : objects_to_bake(scene))
    for (const long long bound : {1, 2, 6, 9}) {
      const ParamValues params = bounded(bound);
      const HalfStack stack = baker.bake(entity, bake_settings(params)).stack;
      const auto counts = counting_places(object_atlas(scene, entity, bake_settings(params)), stack.height);
      const CodecReport report = pca_codec().compress(stack, counts, params, folder.path() / "object");
      EXPECT_LT(std::lround(3 * report.max_error), bound);
    }
}

TEST(PcaCodec, AnotherBoundIsAnotherFile) {
  EXPECT_NE(codec_params_text(bounded(0)), codec_params_text(bounded(6)));
  EXPECT_NE(codec_params_text(bounded(6)), codec_params_text(bounded(9)));
}

TEST(PcaCodec, ShadersCorrectWhatIsBounded) {
  EXPECT_EQ(pca_codec().defines(bounded(0)), ShaderDefines{"CODEC_PCA"});
  EXPECT_EQ(pca_codec().defines(bounded(6)), (ShaderDefines{"CODEC_PCA", "CORRECTED"}));
}

}  // namespace
}  // namespace lightbench
