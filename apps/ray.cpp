#include "classic_render.h"

int main(int argc, char** argv) {
  return dapple::run_classic_render(argc, argv, dapple::AccelKind::linear);
}
