// Blocks of a position map's texels, row by row.
const int kBlock = 8;  // texels along an edge

ivec2 blocks_of(ivec2 size) { return (size + kBlock - 1) / kBlock; }
