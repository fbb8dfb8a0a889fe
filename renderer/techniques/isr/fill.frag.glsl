// Directions in which nothing was seen take the mean of those in which something was.
layout(binding = 9) uniform sampler2D indirect_in;

layout(location = 0) out vec4 indirect;

const float kLeastKnown = 0.05;

void main() {
  vec4 gathered = texelFetch(indirect_in, ivec2(gl_FragCoord.xy), 0);
  indirect = vec4(gathered.rgb / max(gathered.a, kLeastKnown), gathered.a);
}
