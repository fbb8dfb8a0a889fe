// For each block of texels of a position map, the least depth of what can stop a ray on its way to a surface in the block;
// 2 where nothing can.
uniform int occluder_block;  // texels along an edge of a block
layout(binding = 0) uniform sampler2D depths;  // of block_depths.frag.glsl
layout(binding = 1) uniform sampler2D least;   // of least_depth.frag.glsl
uniform ivec2 map_size;
uniform vec2 most_step;  // that a ray moves over the map for each unit of depth

layout(location = 0) out float ceiling;

void main() {
  ivec2 count = textureSize(depths, 0);
  ivec2 block = ivec2(gl_FragCoord.xy);
  float deepest = texelFetch(depths, block, 0).y;
  ceiling = 2.0;
  vec2 block_size = vec2(occluder_block) / vec2(map_size);
  // From farther away no ray falls low enough.
  float most_fall = max(deepest - texelFetch(least, ivec2(0), 0).r, 0.0);
  ivec2 reach = ivec2(min(most_fall * most_step / block_size, vec2(count))) + 1;
  ivec2 first = max(block - reach, ivec2(0));
  ivec2 last = min(block + reach, count - 1);
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x) {
      float depth = texelFetch(depths, ivec2(x, y), 0).x;
      vec2 between = max(abs(vec2(x, y) - vec2(block)) - 1.0, 0.0) * block_size;
      // As a ray from the one to the other falls at least.
      vec2 fall = between / max(most_step, vec2(1e-12));
      if (depth < deepest - max(fall.x, fall.y)) ceiling = min(ceiling, depth);
    }
}
