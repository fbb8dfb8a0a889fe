// Has the objects drawn that a pixel shows.
layout(binding = 0) uniform sampler2D places;

struct Command {
  uint vertices;
  uint instances;
  uint first_vertex;
  uint first_instance;
};
layout(std430, binding = 0) writeonly buffer Commands { Command commands[]; };

void main() {
  int number = int(texelFetch(places, ivec2(gl_FragCoord.xy), 0).z);
  if (number > 0) commands[number - 1].instances = 1u;
}
