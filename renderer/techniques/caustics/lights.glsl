// How each triangle of the water lights the receiver, for method `hit`: two depths between which its volume may meet it,
// or one of these.
const vec2 kLands = vec2(2.0, 0.0);   // all of it where its corners land
const vec2 kMisses = vec2(3.0, 0.0);
