#include "classic/classic_program.h"

int main(int argc, char** argv) {
  return dapple::run_classic_program("describe_scene", argc, argv, dapple::classic_describe);
}
