#include "pipeline/cli.h"

int main(int argc, char** argv) {
  return lightbench::run_cli(argc, argv);
}
