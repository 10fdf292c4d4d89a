/// Denormal numbers, which are too small for the fast arithmetic of processors.
#pragma once

#if defined(__SSE__) && !defined(__EMSCRIPTEN__)
#include <xmmintrin.h>
#endif

namespace pushback {

/// While an object of this class exists, numbers below the smallest normal number count as 0. Without it, arithmetic with an
/// impulse that decays to 0 would take a hundred times as long.
class FlushDenormals {
 public:
#if defined(__SSE__) && !defined(__EMSCRIPTEN__)
  FlushDenormals() { _mm_setcsr(before_ | 0x8040); }
  ~FlushDenormals() { _mm_setcsr(before_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
#else
  FlushDenormals() {}
#endif
};

}  // namespace pushback
