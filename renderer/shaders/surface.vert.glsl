// Surfaces of the scene, for the G-buffer.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_uv;
layout(location = 3) in vec3 color;

uniform mat4 clip_from_object;
uniform mat4 relative_from_object;  // world axes, the camera at the origin
uniform mat3 world_from_normal;

layout(location = 0) out vec3 relative_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec2 surface_uv;
layout(location = 3) out vec3 surface_color;

void main() {
  relative_position = (relative_from_object * vec4(position, 1.0)).xyz;
  world_normal = world_from_normal * normal;
  surface_uv = texture_uv;
  surface_color = color;
  gl_Position = clip_from_object * vec4(position, 1.0);
}
