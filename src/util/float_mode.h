// The processor's floating-point mode, as results rely on it: rounding to nearest, denormals kept.
// A library that was built with -ffast-math may have changed it for the whole process.
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace dapple {

// Sets the standard mode for this thread and gives back at the end what was before.
class StandardFloatMode {
 public:
  StandardFloatMode(const StandardFloatMode&) = delete;
  StandardFloatMode& operator=(const StandardFloatMode&) = delete;

#if defined(__SSE__)
  StandardFloatMode() : before_(_mm_getcsr()) {
    if ((before_ & kModeBits) != kStandard) _mm_setcsr((before_ & ~kModeBits) | kStandard);
  }
  ~StandardFloatMode() {
    if ((before_ & kModeBits) != kStandard) _mm_setcsr(before_);
  }

 private:
  static constexpr unsigned kModeBits = 0xffc0;  // all but the flags of what happened
  static constexpr unsigned kStandard = 0x1f80;  // exceptions masked, nothing flushed

  unsigned before_;
#else
  StandardFloatMode() = default;
  ~StandardFloatMode() {}
#endif
};

}  // namespace dapple
