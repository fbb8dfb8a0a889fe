// The least depth of any surface in a position map.
layout(binding = 0) uniform sampler2D depths;  // of block_depths.frag.glsl

layout(location = 0) out float least;

void main() {
  ivec2 count = textureSize(depths, 0);
  least = 2.0;
  for (int y = 0; y < count.y; ++y)
    for (int x = 0; x < count.x; ++x) least = min(least, texelFetch(depths, ivec2(x, y), 0).x);
}
