// What reading and writing PNG share: libpng reports errors by longjmp, which must not leave a
// function that has objects to destroy.
#pragma once

#include <png.h>

#include <csetjmp>
#include <string>

namespace dapple {

// The state that libpng's callbacks see. Its owner is a function that libpng never jumps over.
struct PngSession {
  png_structp png = nullptr;
  png_infop info = nullptr;
  char message[128] = "libpng cannot start";
};

[[noreturn]] void png_report_error(png_structp png, png_const_charp message);
void png_ignore_warning(png_structp png, png_const_charp message);

// Runs step(state), in which libpng may jump out at any call: false then, with the reason in
// session.message. A step must be written like C, without objects that have destructors.
template <class State>
bool png_run(PngSession& session, void (*step)(State&), State& state) {
  if (setjmp(png_jmpbuf(session.png)) != 0) return false;
  step(state);
  return true;
}

}  // namespace dapple
