// What leaves a place of the texture in a direction: linear, over `scale`. A texel's chart ends in gutters, so that
// bilinear reads never leave it.
#include "techniques/surface_radiance/srgb.glsl"

#ifdef CODEC_RAW
layout(binding = 2) uniform sampler2DArray layers;

vec3 radiance(vec2 texel, NearestDirections near) {
  vec2 at = texel / vec2(size);
  vec3 lower = mix(texture(layers, vec3(at, layer_of(near.theta.x, near.phi.x))).rgb,
                   texture(layers, vec3(at, layer_of(near.theta.x, near.phi.y))).rgb, near.part.y);
  vec3 upper = mix(texture(layers, vec3(at, layer_of(near.theta.y, near.phi.x))).rgb,
                   texture(layers, vec3(at, layer_of(near.theta.y, near.phi.y))).rgb, near.part.y);
  return mix(lower, upper, near.part.x);
}
#endif

#ifdef CODEC_PCA
#ifdef CORRECTED
#include "techniques/surface_radiance/pca_corrected.glsl"
#else
#include "techniques/surface_radiance/pca.glsl"
#endif
#endif

#ifdef CODEC_PIECEWISE
#include "techniques/surface_radiance/piecewise.glsl"
#endif
