// How many volumes are drawn how many times (DrawVolumes of renderer/caustics/volumes.h).
layout(std430, binding = 5) writeonly buffer Command {
  uint index_count;
  uint instances;
  uint first_index;
  uint base_vertex;
  uint base_instance;
};
