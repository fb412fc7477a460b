#include "common/program.h"
#include "dapple/commands.h"

int main(int argc, char** argv) {
  dapple::prepare_process(static_cast<int>(dapple::Errc::io));
  return dapple::run_dapple({argv + 1, argv + argc});
}
