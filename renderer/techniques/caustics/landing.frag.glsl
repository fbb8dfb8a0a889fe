// The flux of triangles that were drawn where their corners land, for each unit of the map's area.
#include "techniques/caustics/flux.glsl"

layout(binding = 0) uniform sampler2D places;

layout(location = 0) in float way;
layout(location = 1) in float depth;
layout(location = 2) in vec2 spot;
layout(location = 3) flat in vec3 flux;
layout(location = 4) flat in float area;

uniform float tolerance;

layout(location = 0) out vec4 caustics;

void main() {
  vec2 place = texelFetch(places, ivec2(gl_FragCoord.xy), 0).xy;
  if (place.y != 1.0 || abs(place.x - depth) > tolerance) discard;
  caustics = flux_of(flux, area, way, spot);
}
