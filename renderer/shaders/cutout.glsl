layout(binding = 1) uniform sampler2D cutout_texture;

// Whether the cut-out texture leaves nothing here: the nearest texel's alpha is below a half. No interpolation, so
// that the edges are those of POV-Ray's stepped texture_map over an image pattern.
bool is_cut_out(vec2 uv) {
  ivec2 size = textureSize(cutout_texture, 0);
  vec2 wrapped = uv - floor(uv);
  ivec2 texel = min(ivec2(wrapped * vec2(size)), size - 1);
  return texelFetch(cutout_texture, texel, 0).a < 0.5;
}
