#include "renderer/techniques/isr_params.h"

#include <algorithm>
#include <cctype>

#include "renderer/direct_light.h"
#include "renderer/techniques/isr_kernel.h"

namespace lightbench {
namespace {

using Values = std::map<std::string, ParamValue>;

/// The thesis's equations and constants. It does not say where the samples lie, how wide the blur is and what
/// epsilon is.
Values paper_values() {
  return {{"weighting", "paper"}, {"source", "albedo"},       {"radius", 0.5},         {"spread", 0.5},
          {"rotation", "none"},   {"form_factor_limit", 1e6}, {"energy_bound", false}, {"background", false},
          {"blur_radius", 4LL},   {"blur", "gaussian"},       {"k_isr", 0.5},          {"k_ssao", 0.5},
          {"normals", "rgb8"},    {"downsampling", "mean"},   {"upsampling", "depth"}};
}

Values with(Values values, const Values& more) {
  for (const auto& [name, value] : more) values[name] = value;
  return values;
}

}  // namespace

std::vector<ParamSpec> isr_params() {
  std::vector<ParamSpec> rows{
      choice_param("weighting", {"area", "paper"},
                   "area: each sample stands for the surface that its share of the kernel covers, and what "
                   "is gathered is multiplied by the albedo at full resolution; paper: eq. 25, "
                   "with one coarse pixel as patch"),
      choice_param(
          "source", {"lit", "diffuse", "albedo"},
          "what a sample sends out: lit: the direct picture with emission and highlights; diffuse: without "
          "highlights, which shine elsewhere than to the camera; albedo: unlit colour, as in the thesis"),
      choice_param("visibility", {"none", "bitmask"},
                   "none: samples round a pixel, whatever stands between, as in the thesis; bitmask: planes "
                   "through the camera are searched outwards, and what is found hides what lies behind it. "
                   "The parameters from `slices` to `unknown` are for bitmask alone, those from `samples` to "
                   "`far_block` and the form factor's for none"),
      integer_param("slices", 2, 1, 64, "planes through the camera that are searched, to both sides"),
      integer_param("steps", 16, 1, 256, "on each side of a slice, all around the camera"),
      number_param("step_exponent", 2.0, 1.0, 6.0,
                   "of the steps' angles: 1 is even, more crowds them round the receiver"),
      number_param("thickness", 0.0, 0.0, 10.0,
                   "how far surfaces go on behind what is seen of them, as a share of the distance; what "
                   "they hide there is unknown"),
      number_param("guard", 1.0, 1.0, 4.0,
                   "how many times as wide as the frame the picture is that is gathered from"),
      integer_param("guard_resolution", 2, 1, 16,
                    "pixels of the frame along the edge of a texel of that picture"),
      integer_param("layers", 1, 1, 8, "surfaces that are kept along a ray, nearest first"),
      choice_param(
          "layer_faces", {"front", "all"},
          "which surfaces behind the first one are kept: those that face the camera as they were modelled, "
          "or all: then a ray that ends before its last layer is known to meet nothing but the background"),
      choice_param("cameras", {"none", "cube"},
                   "cube: six more pictures all around the camera, gathered from where the wide picture does "
                   "not reach"),
      integer_param("camera_size", 64, 8, 2048, "texels along an edge of each of the six"),
      boolean_param("shared_shadows", false,
                    "light what is gathered from with the frame's own shadow maps, which are then fitted to "
                    "both: faster, with coarser shadows"),
      integer_param("bounces", 1, 1, kMaxBounces,
                    "of indirect light; all but the last are gathered for what is gathered from"),
      integer_param("bounce_slices", 2, 1, 64, "slices of the bounces before the last"),
      integer_param(
          "bounce_resolution", 4, 1, 16,
          "texels of what is gathered from, along an edge, for which those bounces are gathered once"),
      integer_param("bounce_steps", 24, 1, 256, "steps of the bounces before the last"),
      choice_param(
          "unknown", {"black", "ambient"},
          "what comes from directions in which nothing was seen: nothing, or the mean of the others"),
      integer_param("samples", 48, 1, kMaxKernelSamples, "samples gathered for each coarse pixel"),
      choice_param("pattern", {"spiral", "jittered", "grid"},
                   "spiral: golden angle, in a disc of `radius`; jittered: at random in the same rings, one "
                   "in each and one in each of as many sectors; grid: the square of coarse pixels around it, "
                   "`spacing` apart, for 8, 24, 48, 80, ... samples"),
      number_param(
          "samples_by_depth", 0.0, 0.0, 2.0,
          "near pixels take more samples (steps, with visibility) than far ones, from 1/4 to 4 times as "
          "many: they go with the distance to the power of minus this, and their mean stays; 0: all alike"),
      number_param("radius", 1.0, 0.001, 4.0, "of the disc, in widths of the image"),
      number_param("spread", 1.5, 0.25, 4.0,
                   "exponent of the samples' distances: 0.5 is uniform in area, more crowds samples at the "
                   "centre, where they weigh most"),
      number_param("spacing", 1.0, 1.0, 256.0, "of the grid, in coarse pixels"),
      choice_param(
          "rotation", {"tiled", "random", "none"},
          "how the kernel is turned from pixel to pixel: in 64 steps and slightly scaled, in an order that "
          "repeats every 8x8 pixels and that the blur removes; by a hash of the place; not at all"),
      integer_param(
          "far_block", 4, 1, 16,
          "edge of the blocks of coarse pixels that samples read where they stand for at least 16 such "
          "blocks: faster, and with less noise; 1: all read coarse pixels, as with weighting paper"),
      choice_param("form_factor", {"point", "disc"},
                   "cos cos dA / (pi r^2), which has no bias; or cos cos dA / (pi r^2 + dA), which has no "
                   "peaks but loses light with few samples"),
      number_param(
          "form_factor_limit", 4.0, 0.001, 1e6,
          "largest form factor of one sample: bounds peaks; 1 and less cost light where samples are few"),
      boolean_param(
          "energy_bound", true,
          "where the form factors around a pixel add up to more than 1 after the blur, scale them to 1"),
      number_param("min_view_cosine", 0.05, 0.001, 1.0,
                   "smallest cosine to the view that a sample's area is divided by"),
      boolean_param("background", true,
                    "gather the scene's background where samples land on it, if it lights: each share is a "
                    "piece of the surrounding sphere as the camera sees it"),
      integer_param("resolution", 2, 1, 8, "pixels along the edge of a coarse pixel"),
      choice_param("downsampling", {"point", "mean"},
                   "what a coarse pixel's depth and normal are: point: those of one of its pixels, the "
                   "nearest to the middle that shows an object, since a mean lies on no surface; mean: those "
                   "of all of its pixels averaged, as in the thesis; colours are averaged either way"),
      choice_param("blur", {"bilateral", "gaussian", "none"}, "of the gathered light, separable"),
      integer_param("blur_radius", 6, 1, 32,
                    "coarse pixels to each side; sigma is half of it and a half more"),
      number_param("blur_plane", 0.02, 1e-5, 10.0,
                   "bilateral blur: distance from the tangent plane, as a share of the depth, at which a "
                   "weight is 1/e"),
      choice_param("upsampling", {"plane", "depth"},
                   "what a pixel takes of the four coarse pixels around it: plane: less the farther they are "
                   "from its tangent plane, and nothing beyond `upsample_tolerance`; depth: eq. 27, less the "
                   "more their depth differs, without a limit"),
      number_param("upsample_epsilon", 0.01, 1e-6, 10.0,
                   "added to the difference in depth, as a share of the depth, that weights are divided by"),
      number_param(
          "upsample_tolerance", 0.1, 1e-6, 1e6,
          "upsampling plane: share of the depth by which a coarse pixel may differ; where none fits, "
          "the nearest counts"),
      number_param("occlusion_radius", 0.02, 0.001, 4.0,
                   "of the kernel of eq. 26, the ambient occlusion, in widths of the image"),
      number_param("occluder_radius", 2.0, 0.01, 1000.0,
                   "of a sample's sphere in eq. 26, in pixels at its depth"),
      number_param("k_isr", 1.0, 0.0, 1000.0, "factor of the indirect light in eq. 29"),
      number_param(
          "k_ssao", 0.0, 0.0, 1.0,
          "power of the ambient occlusion over direct light in eq. 29; with visibility the occlusion is what "
          "of the mask is covered by surfaces nearer than `occlusion_radius`, the nearest most"),
      choice_param("normals", {"octahedral16", "rgb8"}, "how the G-buffer keeps normals; rgb8: eq. 22"),
      boolean_param("direct", true, "show direct light too; else indirect light alone, over black"),
  };
  for (ParamSpec& row : shadow_params()) rows.push_back(std::move(row));
  return rows;
}

std::vector<ParamPreset> isr_presets() {
  const Values paper = paper_values();
  const Values sparse{{"form_factor", "disc"}, {"spread", 0.5},           {"radius", 0.5},
                      {"blur_radius", 4LL},    {"min_view_cosine", 0.15}, {"energy_bound", false}};
  return {
      {"area", {}, "the defaults: physical weights, 48 samples"},
      {"best",
       {{"visibility", "bitmask"},
        {"slices", 2LL},
        {"steps", 64LL},
        {"guard_resolution", 1LL},
        {"layers", 4LL},
        {"layer_faces", "all"},
        {"cameras", "cube"},
        {"bounces", 2LL},
        {"unknown", "ambient"}},
       "visibility all around the camera and through four layers, two bounces"},
      {"fast",
       {{"visibility", "bitmask"},
        {"slices", 1LL},
        {"steps", 16LL},
        {"guard", 4.0},
        {"guard_resolution", 8LL},
        {"bounces", 2LL},
        {"shared_shadows", true},
        {"bounce_slices", 1LL},
        {"bounce_resolution", 2LL},
        {"bounce_steps", 12LL},
        {"unknown", "ambient"}},
       "visibility in one coarse picture four times as wide as the frame, two bounces"},
      {"area-24", {{"samples", 24LL}}, "the same with 24 samples"},
      {"area-48", {{"samples", 48LL}}, "the same with 48 samples"},
      {"area-80", {{"samples", 80LL}}, "the same with 80 samples"},
      {"area-uniform", sparse, "samples uniform in area with bounded weights: the same sum, biased to dark"},
      {"paper", with(paper, {{"samples", 48LL}}), "the equations of the thesis, 48 samples"},
      {"paper-24", with(paper, {{"samples", 24LL}}), "the same with 24 samples"},
      {"paper-48", with(paper, {{"samples", 48LL}}), "the same with 48 samples"},
      {"paper-80", with(paper, {{"samples", 80LL}}), "the same with 80 samples"},
      {"alone", {{"direct", false}}, "display mode \"ISR alone\": indirect light without the direct one"},
      {"esm", {{"shadows", "esm"}}, "display mode \"ISR + ESM\": with exponential shadow maps"},
  };
}

std::vector<std::string> isr_defines(const ParamValues& params) {
  std::vector<std::string> defines;
  for (const char* name :
       {"weighting", "source", "rotation", "form_factor", "downsampling", "blur", "upsampling"}) {
    std::string define = std::string(name) + "_" + params.text(name);
    std::transform(define.begin(), define.end(), define.begin(),
                   [](unsigned char c) { return std::toupper(c); });
    defines.push_back(std::move(define));
  }
  if (params.boolean("energy_bound")) defines.push_back("ENERGY_BOUND");
  return defines;
}

}  // namespace lightbench
