// A file of kernels with the mistake that kernel_symbols_test.cpp looks for: a template outside of
// the instruction set's namespace.
namespace dapple::leaky {

template <class T>
__attribute__((noinline)) T twice(T x) {
  return x + x;
}

namespace N_AVX2 {

template <class T>
__attribute__((noinline)) T thrice(T x) {
  return twice(x) + x;
}

float entry(float x) { return thrice(x); }

}  // namespace N_AVX2
}  // namespace dapple::leaky
