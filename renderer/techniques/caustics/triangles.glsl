// The triangles of the water that light a receiver (MapRays::Triangle).
struct Triangle {
  vec4 flux;
  vec4 area;  // of its image, at depth z: x + z (y + z z)
};
layout(std430, binding = 0) readonly buffer Triangles { Triangle triangles[]; };

float area_at(vec3 area, float depth) { return abs(area.x + depth * (area.y + depth * area.z)); }
