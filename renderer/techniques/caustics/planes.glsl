#include "techniques/caustics/places.glsl"

// The planes across a receiver's box: 0 on the side of the light to `slices` on the far one.

int nearest_plane(float depth, float slices) {
  precise float place = depth * slices + 0.5;  // alike in all programs
  return int(floor(place));
}

// The one that a texel of the position map belongs to: each surface point belongs to exactly one. -1: the receiver is
// not what the light meets there.
int plane_of(vec4 place, float slices) {
  return shows_receiver(place) ? nearest_plane(place.x, slices) : -1;
}

// Its value in depth buffers: exact for all that there can be, 0 for none.
float plane_depth(int plane) { return float(plane + 1) / 8192.0; }
