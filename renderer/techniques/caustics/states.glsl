// Of a triangle of the water, for method `hit`.
const uint kMisses = 0u;
const uint kLands = 1u;
const uint kStraddles = 2u;
