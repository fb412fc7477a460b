// Vectors of the reference tracer, which shares no arithmetic with the library.
#pragma once

#include <cmath>

namespace dapple::test {

struct Triple {
  double x = 0, y = 0, z = 0;
};

inline Triple operator+(Triple a, Triple b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Triple operator-(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Triple operator*(double s, Triple a) { return {s * a.x, s * a.y, s * a.z}; }
inline Triple times(Triple a, Triple b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline double inner(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Triple outer(Triple a, Triple b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Triple a) { return std::sqrt(inner(a, a)); }
inline Triple unit(Triple a) { return (1 / norm(a)) * a; }

}  // namespace dapple::test
