// The water's surface.
layout(location = 0) in vec3 position;  // relative to the camera
layout(location = 1) in vec3 normal;    // upwards

uniform mat4 clip_from_relative;

layout(location = 0) out vec3 relative_position;
layout(location = 1) out vec3 water_normal;

void main() {
  relative_position = position;
  water_normal = normal;
  gl_Position = clip_from_relative * vec4(position, 1.0);
}
