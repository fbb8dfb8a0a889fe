// The tiles of a surround (renderer/surround.h): pictures by cameras at one place that look different ways, side by side.
// Layers, each with what lies behind the one before it, stand on top of one another.
const int kMaxTiles = 7;

struct Tile {
  vec4 corner;  // the ray through the tile's lower left corner, of unit length along its axis; w: first column
  vec4 across;  // what a ray gains from the left edge to the right; w: columns
  vec4 along;   // and from the lower edge to the upper; w: rows
};
layout(std140, binding = 2) uniform Tiles {
  Tile tiles[kMaxTiles];
  vec4 eye_right;    // axes of the view; w: number of tiles
  vec4 eye_up;       // w: rows of a layer
  vec4 eye_forward;  // w: layers
  vec4 wide_view;    // tangents of half the first tile's field of view where it is a wide picture of the view, else 0;
                     // z: the first tile of six that are a cube, or -1
};

// The ray of unit length along its tile's axis through the centre of a texel.
vec3 tile_ray(ivec2 pixel) {
  int tile = int(eye_right.w) - 1;
  while (tile > 0 && float(pixel.x) < tiles[tile].corner.w) --tile;
  int row = pixel.y % int(eye_up.w);
  vec2 uv = (vec2(float(pixel.x) - tiles[tile].corner.w, row) + 0.5) / vec2(tiles[tile].across.w, tiles[tile].along.w);
  return tiles[tile].corner.xyz + uv.x * tiles[tile].across.xyz + uv.y * tiles[tile].along.xyz;
}

// The texel, in the first layer, in which a direction (along the eye axes) lies; x is negative where there is none.
ivec2 tile_texel(vec3 direction) {
  vec3 size = abs(direction);
  if (wide_view.x > 0.0 && direction.z > 0.0 && size.x < wide_view.x * direction.z && size.y < wide_view.y * direction.z) {
    vec2 uv = direction.xy / (wide_view.xy * direction.z) * 0.5 + 0.5;
    return ivec2(uv * vec2(tiles[0].across.w, tiles[0].along.w));
  }
  if (wide_view.z < 0.0) return ivec2(-1);
  // Faces +x -x +y -y +z -z; across and along them lie the two other axes in their order.
  int face;
  vec2 place;
  if (size.x >= size.y && size.x >= size.z) {
    face = direction.x > 0.0 ? 0 : 1;
    place = direction.yz / size.x;
  } else if (size.y >= size.z) {
    face = direction.y > 0.0 ? 2 : 3;
    place = direction.xz / size.y;
  } else {
    face = direction.z > 0.0 ? 4 : 5;
    place = direction.xy / size.z;
  }
  int tile = int(wide_view.z) + face;
  float edge = tiles[tile].across.w;
  return ivec2(tiles[tile].corner.w, 0.0) + ivec2(min((place * 0.5 + 0.5) * edge, edge - 0.5));
}

// How wide a texel of the first layer is, at distance 1 along its tile's axis.
float texel_width(ivec2 texel) {
  vec4 across = tiles[float(texel.x) < tiles[0].across.w ? 0 : int(eye_right.w) - 1].across;
  return length(across.xyz) / across.w;
}
