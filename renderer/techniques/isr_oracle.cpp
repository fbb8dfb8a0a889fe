#include "renderer/techniques/isr_oracle.h"

#include <algorithm>

#include "renderer/frame_context.h"
#include "renderer/path_tracer.h"
#include "renderer/techniques/isr_params.h"

namespace lightbench {
namespace {

constexpr const char* kLimits[] = {"guard",   "layers",  "layer_faces", "cameras",
                                   "bounces", "unknown", "background"};
constexpr int kOracleVersion = 2;  // raised when equal limits give another picture

std::vector<ParamSpec> oracle_params() {
  const std::vector<ParamSpec> isr = isr_params();
  std::vector<ParamSpec> rows;
  for (const char* name : kLimits) rows.push_back(*std::ranges::find(isr, name, &ParamSpec::name));
  rows.push_back(integer_param("samples", 256, 2, 65536,
                               "rays that each pixel gathers with, rounded up to an even number"));
  return rows;
}

/// Those of `isr` that have visibility, as far as they say what is seen.
std::vector<ParamPreset> oracle_presets() {
  std::vector<ParamPreset> presets;
  for (ParamPreset& preset : isr_presets()) {
    if (!preset.values.contains("visibility")) continue;
    std::erase_if(preset.values, [](const auto& value) {
      return std::ranges::find(kLimits, value.first) == std::end(kLimits);
    });
    presets.push_back({preset.name, preset.values, "the pictures of `isr`'s preset of that name"});
  }
  return presets;
}

PathTracerOptions options_of(const ParamValues& params) {
  SightLimits limits;
  limits.wide_factor = float(params.number("guard"));
  limits.all_around = params.text("cameras") == "cube";
  limits.layers = params.integer("layers");
  limits.front_faces = params.text("layer_faces") == "front";
  limits.fill_unknown = params.text("unknown") == "ambient";
  PathTracerOptions options;
  options.bounces = params.integer("bounces");
  options.samples = params.integer("samples");
  options.seed = default_seed(PathTracedUse::variant);
  options.background = params.boolean("background");
  options.limits = limits;
  return options;
}

void render(FrameContext& frame, const ParamValues& params) {
  const FrameRequest& request = frame.request();
  PathTracedImage traced = trace_paths(request.scene, request.view, request.width, request.height,
                                       request.samples, options_of(params));
  for (const RayRate& rate : traced.rays) frame.add_pass_time(rate.name + " rays", rate.seconds);
  frame.set_image(std::move(traced.image));
  frame.keep_buffer("indirect", traced.indirect);
  frame.keep_buffer("unknown", traced.unknown);
}

}  // namespace

std::map<std::string, ParamValue> isr_oracle_limits(const ParamValues& isr) {
  std::map<std::string, ParamValue> limits;
  if (isr.text("visibility") == "none") {
    limits["background"] = isr.boolean("background");
    return limits;
  }
  for (const char* name : kLimits) limits[name] = isr.all().at(name);
  return limits;
}

Technique isr_oracle_technique() {
  Technique technique;
  technique.name = "isr_oracle";
  technique.doc =
      "what `isr` could gather at best from what its pictures hold: the same by exact rays, without OpenGL; "
      "the "
      "defaults are those of preset `area`, the frame and one bounce";
  technique.params = oracle_params();
  technique.presets = oracle_presets();
  technique.buffers = {{"indirect", "what is added to the direct light, linear RGB; 0 on the background"},
                       {"unknown", "share of a pixel's rays that went to what no picture holds"}};
  technique.bounces = [](const ParamValues& params) { return params.integer("bounces"); };
  technique.version = 100 * kPathTracerVersion + kOracleVersion;
  technique.needs_gl = false;
  technique.offline = true;
  technique.limited = true;
  technique.render = render;
  return technique;
}

}  // namespace lightbench
