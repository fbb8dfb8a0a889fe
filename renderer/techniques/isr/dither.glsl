// What differs from pixel to pixel, so that a blur can remove the pattern of few samples.

uint pixel_hash(ivec2 pixel) {
  uint h = uint(pixel.x) * 0x8da6b343u + uint(pixel.y) * 0xd8163841u;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return h ^ (h >> 15);
}

// 0 to 63, each once in 8x8 pixels. Ordered dithering: the bits of x ^ y and y, interleaved and reversed.
uint tiled_order(ivec2 pixel) {
  uint x = uint(pixel.x ^ pixel.y) & 7u;
  uint y = uint(pixel.y) & 7u;
  uint n = 0u;
  for (int bit = 0; bit < 3; ++bit) {
    n = (n << 2) | ((x & 1u) << 1) | (y & 1u);
    x >>= 1;
    y >>= 1;
  }
  return n;
}
