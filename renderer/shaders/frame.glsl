// The camera of the picture being drawn (renderer/frame_camera.h).
layout(std140, binding = 0) uniform Frame {
  vec4 camera_position;  // w: far
  vec4 far_corner;       // f_o, f_u, f_v: see world_position
  vec4 far_u;
  vec4 far_v;
  vec4 camera_forward;   // w: near
  vec4 frame_size;       // width, height, 1 / width, 1 / height
  vec4 half_angles;      // tangents of half the horizontal and vertical field of view, pixel height at distance 1, unused
  mat4 clip_from_world;
};

// The world position seen at uv (0..1, y up) where eye-space z / far is z (image-space radiosity thesis, eq. 24).
vec3 world_position(vec2 uv, float z) {
  return camera_position.xyz + (far_corner.xyz + uv.x * far_u.xyz + uv.y * far_v.xyz) * z;
}
