#include "renderer/caustics/caustics_params.h"

#include <algorithm>

#include "renderer/direct_light.h"

namespace lightbench {

std::vector<ParamSpec> caustics_params() {
  std::vector<ParamSpec> rows{
      choice_param(
          "method", {"level_map", "hit", "volumetric"},
          "level_map: the water's triangles are cut by planes across the light, and a plane lights the "
          "texels that are nearest to it; hit: each triangle is drawn once, where its corners' light lands; "
          "volumetric: the method before the thesis's, with an image of the receiver for each plane"),
      integer_param("slices", 100, 1, kMaxSlices,
                    "a receiver's box is cut into so many along the light, by one plane more"),
      integer_param("map_size", 512, 16, 8192, "texels along an edge of a receiver's maps"),
      choice_param(
          "slicing", {"local", "smart", "smart_read_back", "uniform"},
          "level_map: which planes the water's triangles are cut by: local: each by those that the receiver "
          "lies on where the triangle's light passes; smart: all by those that the receiver lies on "
          "anywhere, found on the GPU; smart_read_back: the same, found from the position map read "
          "back; uniform: all by all. The picture is the same"),
      choice_param(
          "plane_test", {"equal", "discard"},
          "how a texel's plane is told: equal: by a depth buffer that holds the planes; discard: in the "
          "shader, as in the thesis. The picture is the same"),
      choice_param(
          "straddling", {"split", "drop"},
          "hit: what is done with triangles whose light falls on several surfaces: split: each texel "
          "that they may light tells by its own depth whether it is in their light; drop: they are left out"),
      choice_param("slice_images", {"whole", "clusters"},
                   "volumetric: what is drawn for each plane: whole: all; clusters: clusters of at most 1024 "
                   "triangles "
                   "that it may hold"),
      integer_param(
          "layers", 2, 1, 2,
          "surfaces behind one another that the position map holds: with 2, each ray is followed back "
          "through it, and what the ray passes through beside the axis stops it; with 1, only what "
          "lies along the axis stops light"),
      integer_param(
          "steps", 16, 1, 1024,
          "in how many a ray is followed through the position map at most: by hit to where it lands, before "
          "ten bisections, and with two layers back towards the light"),
      number_param(
          "least_area", 1.0 / 256, 0, 16,
          "of the image of a triangle of the water, in texels: where light folds it goes to 0, and its "
          "brightness beyond all bounds"),
      boolean_param("fresnel", false, "whether the water reflects a part of the light"),
      boolean_param("level_of_detail", false,
                    "cut a receiver into no more slices than it is pixels large in the picture"),
      boolean_param(
          "surface", true,
          "draw the water's surface, which shows what is below it refracted and the background reflected"),
      boolean_param("culling", true,
                    "leave out triangles of the water whose light misses the receiver's box"),
      choice_param(
          "color", {"surface", "map"},
          "surface: each pixel's own colour is lit; map: that of the receiver's diffuse map, as in the "
          "thesis"),
  };
  for (ParamSpec& row : shadow_params()) rows.push_back(std::move(row));
  return rows;
}

CausticsOptions caustics_options(const ParamValues& params) {
  CausticsOptions options;
  options.map_size = params.integer("map_size");
  options.layers = params.integer("layers");
  options.level_of_detail = params.boolean("level_of_detail");
  options.surface = params.boolean("surface");
  options.fresnel = params.boolean("fresnel");
  options.culling = params.boolean("culling") ? VolumeCulling::on : VolumeCulling::off;
  options.color = params.text("color") == "map" ? ReceiverColor::map : ReceiverColor::surface;
  options.level_map.slices = params.integer("slices");
  options.level_map.test = params.text("plane_test") == "equal" ? PlaneTest::equal : PlaneTest::discard;
  const std::string& slicing = params.text("slicing");
  options.level_map.slicing = slicing == "local"     ? Slicing::local
                              : slicing == "smart"   ? Slicing::smart
                              : slicing == "uniform" ? Slicing::uniform
                                                     : Slicing::smart_read_back;
  options.least_area = params.number("least_area");
  options.steps = options.hit.steps = params.integer("steps");
  options.hit.straddling = params.text("straddling") == "split" ? Straddling::split : Straddling::drop;
  options.volumetric.drawing =
      params.text("slice_images") == "whole" ? SliceDrawing::whole : SliceDrawing::clusters;
  const std::string& method = params.text("method");
  options.method = method == "level_map" ? CausticsMethod::level_map
                   : method == "hit"     ? CausticsMethod::hit
                                         : CausticsMethod::volumetric;
  return with_slices(options, options.level_map.slices);
}

CausticsOptions with_slices(CausticsOptions options, int most) {
  const int slices = std::min(options.level_map.slices, most);
  options.level_map.slices = options.hit.slices = options.volumetric.slices = slices;
  return options;
}

}  // namespace lightbench
