// One light's share of the direct light, added to the targets.
#include "shaders/gbuffer.glsl"
#include "shaders/light.glsl"

uniform float shadow_bias;
uniform float esm_sharpness;
uniform int pcf_radius;

#ifndef SHADOW_NONE
#include "shaders/shadow.glsl"
#endif

layout(location = 0) out vec4 lit;
#ifdef WITH_IRRADIANCE
layout(location = 1) out vec4 irradiance;
#endif
#ifdef WITH_BACK
layout(location = 2) out vec4 back_irradiance;
#endif
#ifdef WITH_VISIBILITY
layout(location = VISIBILITY_LOCATION) out float mean_visibility;
#endif

// Kinds in the order of Attenuation::Kind.
float attenuation(float d) {
  switch (int(light_attenuation.x)) {
    case 1: return 2.0 / (1.0 + pow(d / light_attenuation.y, light_attenuation.z));
    case 2: return 1.0 / (d * d);
    case 3: {
      float part = d / light_attenuation.w;
      return max(1.0 - part * part, 0.0);
    }
    default: return 1.0;
  }
}

float cone(vec3 to_light) {
  if (light_direction.w == 0.0) return 1.0;
  float cosine = dot(-to_light, light_direction.xyz);
  if (light_cone.x <= light_cone.y) return cosine >= light_cone.y ? 1.0 : 0.0;
  return smoothstep(light_cone.y, light_cone.x, cosine);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = gbuffer_z(pixel);
  if (z <= 0.0) discard;
  vec3 position = gbuffer_position(pixel, z);
  vec3 normal = gbuffer_normal(pixel);

  vec3 offset = light_position.xyz - position;
  float distance_to_light = max(length(offset), 1e-12);
  vec3 to_light = light_position.w != 0.0 ? offset / distance_to_light : -light_direction.xyz;
  float strength = light_position.w != 0.0 ? attenuation(distance_to_light) * cone(to_light) : 1.0;
  float n_dot_l = dot(normal, to_light);

#ifdef WITH_BACK
  float lit_cosine = abs(n_dot_l);  // of the side that faces the light
#else
  float lit_cosine = n_dot_l;
#endif
  float seen = 0.0;
  if (lit_cosine > 0.0 && strength > 0.0) {
#ifdef SHADOW_NONE
    seen = 1.0;
#else
    seen = visibility(receiver_at(position, z, gbuffer_geometric_normal(pixel)), lit_cosine);
#endif
  }
  vec3 arriving = light_color.rgb * strength * seen;
  vec3 diffuse = arriving * max(n_dot_l, 0.0);

  vec2 specular = texelFetch(gbuffer_specular, pixel, 0).rg;
  vec3 viewer = normalize(camera_position.xyz - position);
  float r_dot_v = dot(reflect(-to_light, normal), viewer);
  vec3 gloss = r_dot_v > 0.0 ? arriving * (specular.x * pow(r_dot_v, specular.y)) : vec3(0.0);

  lit = vec4(texelFetch(gbuffer_albedo, pixel, 0).rgb * diffuse + gloss, 0.0);
#ifdef WITH_IRRADIANCE
  irradiance = vec4(diffuse, 0.0);
#endif
#ifdef WITH_BACK
  back_irradiance = vec4(arriving * max(-n_dot_l, 0.0), 0.0);
#endif
#ifdef WITH_VISIBILITY
  mean_visibility = (seen - 1.0) * light_color.w;
#endif
}
