// The planes that triangles of the water are to be cut by, as mark_cuts.comp.glsl marks them.
layout(std430, binding = 2) readonly buffer Marks { uint marks[]; };  // a bit for each plane
uniform int listed;  // triangles
uniform int words;   // for each of them

// Returns by how many planes a triangle is to be cut; 0 behind the last one.
uint marked_planes(int triangle) {
  uint count = 0u;
  if (triangle < listed)
    for (int word = 0; word < words; ++word) count += uint(bitCount(marks[triangle * words + word]));
  return count;
}
