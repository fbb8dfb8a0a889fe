// The light of a caustics map on its receiver, added to the picture (the water caustics thesis, 4.6 and 4.7.1).
#include "shaders/gbuffer.glsl"
#include "techniques/caustics/places.glsl"

layout(binding = 6) uniform sampler2D entities;
layout(binding = 7) uniform sampler2D places;
layout(binding = 8) uniform sampler2D caustics;
#ifdef MAP_COLOR
layout(binding = 9) uniform sampler2D diffuse_map;
#endif

uniform int receiver;
uniform vec3 box_center;  // relative to the camera
uniform vec3 box_u;       // unit axes
uniform vec3 box_v;
uniform vec3 box_w;
uniform vec3 box_size;  // along u, v and w

layout(location = 0) out vec4 lit;
layout(location = 1) out vec4 landed;  // flux for each unit of area across the light's axis

// Of the four texels around, those that show this surface, by where its plane is under their centres.
vec3 caustics_at(vec3 place, vec2 slope) {
  vec2 size = vec2(textureSize(places, 0));
  vec2 texel = place.xy * size - 0.5;
  vec2 first = floor(texel);
  vec2 part = texel - first;
  vec2 step = 1.0 / size;
  // By half a texel's slope and the width of a texel: curved surfaces leave their planes.
  float bias = 0.5 * dot(abs(slope), step) + max(box_size.x * step.x, box_size.z * step.y) / box_size.y;
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 corner = vec2(i & 1, i >> 1);
    ivec2 at = ivec2(first + corner);
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(size)))) continue;
    vec4 shown = texelFetch(places, at, 0);
    float expected = place.z + dot((first + corner - texel) * step, slope);
    if (!shows_receiver(shown) || abs(shown.x - expected) > bias) continue;
    vec2 near = mix(1.0 - part, part, corner);
    float weight = near.x * near.y;
    sum += weight * texelFetch(caustics, at, 0).rgb;
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : vec3(0.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = gbuffer_z(pixel);
  if (z <= 0.0 || int(texelFetch(entities, pixel, 0).r) != receiver + 1) discard;
  float cosine = dot(gbuffer_normal(pixel), box_v);
  vec3 face = gbuffer_geometric_normal(pixel);
  float across = dot(face, box_v);
  // The map's surface is the one that faces the light; the shading normal must agree.
  if (cosine <= 0.0 || across <= 0.0) discard;
  vec3 from_center = gbuffer_position(pixel, z) - camera_position.xyz - box_center;
  vec3 along = vec3(dot(box_u, from_center), dot(box_v, from_center), dot(box_w, from_center));
  vec3 place = 0.5 + vec3(along.x / box_size.x, along.z / box_size.z, -along.y / box_size.y);
  vec2 slope = vec2(dot(face, box_u) * box_size.x, dot(face, box_w) * box_size.z) / (across * box_size.y);
  vec3 flux = caustics_at(place, slope);
#ifdef MAP_COLOR
  vec3 albedo = texture(diffuse_map, place.xy).rgb;
#else
  vec3 albedo = texelFetch(gbuffer_albedo, pixel, 0).rgb;
#endif
  lit = vec4(albedo * flux * cosine, 0.0);
  landed = vec4(flux, 0.0);
}
