#pragma once

#include <array>

/// The shader files of technique `caustics`.
namespace lightbench {

inline constexpr const char* kSurfaceVertex = "shaders/surface.vert.glsl";
inline constexpr const char* kReceiverVertex = "techniques/caustics/receiver.vert.glsl";
inline constexpr const char* kReceiverFragment = "techniques/caustics/receiver.frag.glsl";
inline constexpr const char* kPlaneDepth = "techniques/caustics/plane_depth.frag.glsl";
inline constexpr const char* kVolumeVertex = "techniques/caustics/volume.vert.glsl";
inline constexpr const char* kVolumeFragment = "techniques/caustics/volume.frag.glsl";
inline constexpr const char* kUsedPlanes = "techniques/caustics/used_planes.comp.glsl";
inline constexpr const char* kListPlanes = "techniques/caustics/list_planes.comp.glsl";
inline constexpr const char* kHits = "techniques/caustics/hits.comp.glsl";
inline constexpr const char* kBlocks = "techniques/caustics/blocks.comp.glsl";
inline constexpr const char* kBlockDepths = "techniques/caustics/block_depths.frag.glsl";
inline constexpr const char* kLeastDepth = "techniques/caustics/least_depth.frag.glsl";
inline constexpr const char* kCeilings = "techniques/caustics/ceilings.frag.glsl";
inline constexpr const char* kCoarserBlocks = "techniques/caustics/coarser_blocks.comp.glsl";
inline constexpr const char* kJudge = "techniques/caustics/judge.comp.glsl";
inline constexpr const char* kMarkCuts = "techniques/caustics/mark_cuts.comp.glsl";
inline constexpr const char* kCountCuts = "techniques/caustics/count_cuts.comp.glsl";
inline constexpr const char* kPlaceCuts = "techniques/caustics/place_cuts.comp.glsl";
inline constexpr const char* kListCuts = "techniques/caustics/list_cuts.comp.glsl";
inline constexpr const char* kLandingVertex = "techniques/caustics/landing.vert.glsl";
inline constexpr const char* kLandingFragment = "techniques/caustics/landing.frag.glsl";
inline constexpr const char* kSweepVertex = "techniques/caustics/sweep.vert.glsl";
inline constexpr const char* kSweepFragment = "techniques/caustics/sweep.frag.glsl";
inline constexpr const char* kCombine = "techniques/caustics/combine.frag.glsl";
inline constexpr const char* kWaterVertex = "techniques/caustics/water.vert.glsl";
inline constexpr const char* kWaterFragment = "techniques/caustics/water.frag.glsl";
inline constexpr const char* kShadeFragment = "techniques/caustics/shade.frag.glsl";
inline constexpr const char* kUnlit = "techniques/caustics/unlit.frag.glsl";
inline constexpr const char* kCast = "techniques/caustics/cast.frag.glsl";

inline constexpr std::array kCausticsShaders{
    kSurfaceVertex,   kReceiverVertex, kReceiverFragment, kPlaneDepth,   kVolumeVertex,
    kVolumeFragment,  kUsedPlanes,     kListPlanes,       kHits,         kBlocks,
    kCoarserBlocks,   kCountCuts,      kBlockDepths,      kLeastDepth,   kCeilings,
    kJudge,           kMarkCuts,       kPlaceCuts,        kListCuts,     kLandingVertex,
    kLandingFragment, kSweepVertex,    kSweepFragment,    kCombine,      kShadeFragment,
    kUnlit,           kCast,           kWaterVertex,      kWaterFragment};

}  // namespace lightbench
