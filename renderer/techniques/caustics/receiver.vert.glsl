// Surfaces of the scene, along the axis of a receiver's box.
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 texture_uv;
layout(location = 3) in vec3 color;

uniform mat4 clip_from_object;
uniform mat4 relative_from_object;  // world axes, the middle of the box at the origin
uniform vec4 depth_in_box;

// A parallel view: nothing is divided by the distance.
layout(location = 0) noperspective out vec2 depth_height;  // in the box; above its middle
layout(location = 1) noperspective out vec2 surface_uv;
layout(location = 2) noperspective out vec3 surface_color;

invariant gl_Position;  // alike for the map, its second layer and slices

void main() {
  vec4 relative = relative_from_object * vec4(position, 1.0);
  precise float depth = dot(depth_in_box, relative);  // alike for the whole box and for its slices
  depth_height = vec2(depth, relative.y);
  surface_uv = texture_uv;
  surface_color = color;
  gl_Position = clip_from_object * vec4(position, 1.0);
}
