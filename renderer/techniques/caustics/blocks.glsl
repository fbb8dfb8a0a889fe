// Blocks of a position map's texels, row by row.
const int kBlock = 8;  // texels along an edge
const ivec2 kNoPlanes = ivec2(8192, -1);  // the first and the last, where no texel shows the receiver

ivec2 blocks_of(ivec2 size) { return (size + kBlock - 1) / kBlock; }
