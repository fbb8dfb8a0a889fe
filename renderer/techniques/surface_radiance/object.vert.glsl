// Surfaces of one object, for the picture of where in which texture each pixel lies.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_uv;
layout(location = 3) in vec2 texel;

uniform mat4 clip_from_object;
uniform mat3 world_from_normal;

layout(location = 0) out vec3 world_normal;
layout(location = 1) out vec2 surface_uv;
layout(location = 2) out vec2 surface_texel;

void main() {
  world_normal = world_from_normal * normal;
  surface_uv = texture_uv;
  surface_texel = texel;
  gl_Position = clip_from_object * vec4(position, 1.0);
}
