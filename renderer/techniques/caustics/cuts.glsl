// A cut is a triangle of the water, counted from the first of those that are listed at a time, and a plane of the
// receiver's box (renderer/caustics/volume_cuts.h).
uint cut_of(uint triangle, int plane) { return triangle << 13 | uint(plane); }
uint triangle_of_cut(uint cut) { return cut >> 13; }
int plane_of_cut(uint cut) { return int(cut & 8191u); }
