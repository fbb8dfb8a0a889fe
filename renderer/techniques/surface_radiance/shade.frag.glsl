// Shows what the pixels' texels send to the camera: each pixel once, one object at a time.
#include "shaders/frame.glsl"
#include "shaders/octahedral.glsl"
#include "techniques/surface_radiance/directions.glsl"

// The stencil says where the object is; without this, `discard` makes it come too late.
layout(early_fragment_tests) in;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

layout(binding = 0) uniform sampler2D places;
layout(binding = 1) uniform sampler2D normals;

uniform int object;
uniform ivec2 size;   // of the object's texture, in texels
uniform int sides;    // 1: nothing leaves the back
uniform float scale;  // the radiance that stands for 1

#include "techniques/surface_radiance/codec.glsl"

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(places, pixel, 0);
  if (int(place.z) != object + 1) discard;
  color = vec4(0.0, 0.0, 0.0, 1.0);
  if (place.w != 0.0 && sides == 1) return;
  vec2 texel = place.xy + vec2(0.0, place.w * float(size.y / sides));
  vec3 normal = decode_octahedral(texelFetch(normals, pixel, 0).xy);
  vec3 ray = far_corner.xyz + uv.x * far_u.xyz + uv.y * far_v.xyz;
  NearestDirections nearest = nearest_directions(local_from_world(normal) * -ray);
  color.rgb = scale * radiance(texel, nearest);
}
