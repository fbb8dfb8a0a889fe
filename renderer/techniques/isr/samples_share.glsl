// Samples by depth: near pixels take more than far ones, and all together as many as without it, but for the bounds.
const float kMostSamples = 4.0;  // times the mean, and its inverse the fewest; also in isr_samples.h

// `scale` makes the mean over the picture 1.
float samples_share(float distance_, float exponent, float scale) {
  return clamp(scale * pow(distance_, -exponent), 1.0 / kMostSamples, kMostSamples);
}
