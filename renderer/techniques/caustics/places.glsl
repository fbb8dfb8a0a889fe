// A texel of the position map (ReceiverMap::places of renderer/caustics/receiver_map.h): the depth in the box of the first
// surface below the water; 1 where that is the receiver's, plus 2 where it is a back face; by how much its plane gets
// deeper along each side of the map.
bool shows_receiver(vec4 place) { return place.y == 1.0 || place.y == 3.0; }
bool shows_back_face(vec4 place) { return place.y >= 2.0; }

// Rays that move by `ray_step` over the map for each unit of depth land where the surface is as deep as they are. Where it is
// tilted against them, what passes through a unit of area across the axis lands on 1 / (1 - ray_step . gradient) units of the
// map's area, and where it faces away from them, on none.
float tilt_factor(vec2 ray_step, vec4 place) {
  precise float factor = 1.0 - dot(ray_step, place.zw);  // alike in all programs
  return max(factor, 0.0);
}
