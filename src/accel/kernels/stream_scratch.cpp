#include "accel/kernels/stream_scratch.h"

#include <memory>
#include <new>

namespace dapple {

StreamScratch* stream_scratch() noexcept {
  thread_local std::unique_ptr<StreamScratch> scratch;
  // Without initialization: a million bytes, of which most are written before they are read.
  if (!scratch) scratch.reset(new (std::nothrow) StreamScratch);
  return scratch.get();
}

}  // namespace dapple
