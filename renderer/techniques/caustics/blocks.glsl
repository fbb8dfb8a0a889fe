// Blocks of a position map's texels, row by row; after them, level by level, blocks of 2 x 2 of the level before, up to one
// that holds all. So that no loop over them is long: OSMesa's shaders end all loops after 65535 rounds together.
const int kBlock = 8;  // texels along an edge
const ivec2 kNoPlanes = ivec2(8192, -1);  // the first and the last, where no texel shows the receiver

ivec2 blocks_of(ivec2 size) { return (size + kBlock - 1) / kBlock; }
ivec2 coarser(ivec2 count) { return (count + 1) / 2; }
