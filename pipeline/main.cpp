#include "base/descriptors.h"
#include "pipeline/cli.h"

int main(int argc, char** argv) {
  lightbench::open_standard_descriptors();
  return lightbench::run_cli(argc, argv);
}
