#include "classic/classic_program.h"

int main(int argc, char** argv) {
  return dapple::run_classic_program("ray", argc, argv, [](const auto& arguments) {
    return dapple::classic_render(arguments, dapple::AccelKind::linear);
  });
}
