// One direction of a Gaussian blur of occluder depths in log space: the logarithm of the mean of exp(c * depth), taken
// relative to the largest so that nothing overflows.
layout(binding = 9) uniform sampler2D depths;
layout(location = 0) out float blurred;

uniform ivec2 direction;
uniform int radius;
uniform float esm_sharpness;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(depths, 0) - 1;
  float largest = texelFetch(depths, pixel, 0).r;
  for (int i = -radius; i <= radius; ++i)
    largest = max(largest, texelFetch(depths, clamp(pixel + direction * i, ivec2(0), last), 0).r);
  float sum = 0.0;
  float weights = 0.0;
  float sigma = max(float(radius) * 0.5, 0.5);
  for (int i = -radius; i <= radius; ++i) {
    float weight = exp(-float(i * i) / (2.0 * sigma * sigma));
    float depth = texelFetch(depths, clamp(pixel + direction * i, ivec2(0), last), 0).r;
    sum += weight * exp(esm_sharpness * (depth - largest));
    weights += weight;
  }
  blurred = largest + log(sum / weights) / esm_sharpness;
}
