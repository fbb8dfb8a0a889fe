// A texel of the position map (ReceiverMap::places of renderer/caustics/receiver_map.h): the depth in the box of the first
// surface below the water; whose it is (`owner`); by how much its plane gets deeper along each side of the map.

// What `places` keeps of a surface: 1 where it is the receiver's, plus 2 where it is a back face, plus 4 for each entity before
// its own.
float owner_of(int entity, int receiver, bool is_back) {
  return float(4 * entity + (is_back ? 2 : 0) + (entity == receiver ? 1 : 0));
}
bool shows_receiver(vec4 place) { return (int(place.y) & 1) == 1; }
bool shows_back_face(vec4 place) { return (int(place.y) & 2) == 2; }
int entity_of(vec4 place) { return int(place.y) >> 2; }

// Rays that move by `ray_step` over the map for each unit of depth land where the surface is as deep as they are. Where it is
// tilted against them, what passes through a unit of area across the axis lands on 1 / (1 - ray_step . gradient) units of the
// map's area, and where it faces away from them, on none.
float tilt_factor(vec2 ray_step, vec4 place) {
  precise float factor = 1.0 - dot(ray_step, place.zw);  // alike in all programs
  return max(factor, 0.0);
}
