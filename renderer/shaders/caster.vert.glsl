// What casts a shadow: depth only.
layout(location = 0) in vec3 position;
#ifdef CUTOUT
layout(location = 2) in vec2 texture_uv;
layout(location = 0) out vec2 surface_uv;
#endif

uniform mat4 clip_from_object;

void main() {
#ifdef CUTOUT
  surface_uv = texture_uv;
#endif
  gl_Position = clip_from_object * vec4(position, 1.0);
}
