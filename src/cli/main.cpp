#include "cli/program.hpp"

int main(int argc, char** argv) {
  return manifuzz::run_program(argc, argv);
}
