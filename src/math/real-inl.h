// A number or a truth of each lane, with the operators of C++: formulas read as the scalar ones do,
// and compute the same, operation for operation.
#include "math/simd-inl.h"

#if defined(DAPPLE_MATH_REAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_MATH_REAL_INL_H
#undef DAPPLE_MATH_REAL_INL_H
#else
#define DAPPLE_MATH_REAL_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct Real {
  FloatVec v;

  Real() = default;  // not initialised: `{}` is zero
  HWY_INLINE Real(float x) : v(all(x)) {}
  HWY_INLINE Real(FloatVec x) : v(x) {}
};

struct Bool {
  FloatMask m;
};

HWY_INLINE Real operator+(Real a, Real b) { return hn::Add(a.v, b.v); }
HWY_INLINE Real operator-(Real a, Real b) { return hn::Sub(a.v, b.v); }
HWY_INLINE Real operator*(Real a, Real b) { return hn::Mul(a.v, b.v); }
HWY_INLINE Real operator/(Real a, Real b) { return hn::Div(a.v, b.v); }
HWY_INLINE Real operator-(Real a) { return hn::Neg(a.v); }
HWY_INLINE Bool operator<(Real a, Real b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE Bool operator>(Real a, Real b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE Bool operator<=(Real a, Real b) { return {hn::Le(a.v, b.v)}; }
HWY_INLINE Bool operator>=(Real a, Real b) { return {hn::Ge(a.v, b.v)}; }
// Both sides are always computed.
HWY_INLINE Bool operator&&(Bool a, Bool b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE Bool operator||(Bool a, Bool b) { return {hn::Or(a.m, b.m)}; }
HWY_INLINE Bool operator!(Bool a) { return {hn::Not(a.m)}; }
HWY_INLINE bool any(Bool a) { return any(a.m); }

HWY_INLINE Real select(Bool mask, Real yes, Real no) { return hn::IfThenElse(mask.m, yes.v, no.v); }
HWY_INLINE Real where(Bool mask, Real yes) { return hn::IfThenElseZero(mask.m, yes.v); }
// As std::min, std::max and std::clamp.
HWY_INLINE Real min(Real a, Real b) { return select(b < a, b, a); }
HWY_INLINE Real max(Real a, Real b) { return select(a < b, b, a); }
HWY_INLINE Real clamp(Real x, Real lo, Real hi) { return select(x < lo, lo, min(x, hi)); }
HWY_INLINE Real sqrt(Real x) { return hn::Sqrt(x.v); }
HWY_INLINE Real abs(Real x) { return hn::Abs(x.v); }

struct Real2 {
  Real x, y;
};

struct Real3 {
  Real x, y, z;

  Real3() = default;
  HWY_INLINE Real3(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
  HWY_INLINE Real3(const FloatVec3& v) : x(v.x), y(v.y), z(v.z) {}
  HWY_INLINE FloatVec3 vec() const { return {x.v, y.v, z.v}; }
};

HWY_INLINE Real3 grey(Real x) { return {x, x, x}; }
HWY_INLINE Real3 operator-(const Real3& a) { return {-a.x, -a.y, -a.z}; }
HWY_INLINE Real3 operator+(const Real3& a, const Real3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Real3 operator-(const Real3& a, const Real3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Real3 operator*(const Real3& a, const Real3& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
HWY_INLINE Real3 operator*(Real s, const Real3& a) { return {s * a.x, s * a.y, s * a.z}; }
HWY_INLINE Real3 operator/(const Real3& a, Real s) { return (Real(1.0f) / s) * a; }
HWY_INLINE Real dot(const Real3& a, const Real3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE Real3 cross(const Real3& a, const Real3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Real3 normalize(const Real3& a) { return a / sqrt(dot(a, a)); }
HWY_INLINE Real3 select(Bool mask, const Real3& yes, const Real3& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
HWY_INLINE Real3 where(Bool mask, const Real3& yes) {
  return {where(mask, yes.x), where(mask, yes.y), where(mask, yes.z)};
}

// shading/colour.h
HWY_INLINE Real luminance(const Real3& c) {
  return Real(0.2126f) * c.x + Real(0.7152f) * c.y + Real(0.0722f) * c.z;
}
HWY_INLINE Real max_component(const Real3& c) {
  const Real xy = select(c.x > c.y, c.x, c.y);
  return select(xy > c.z, xy, c.z);
}
HWY_INLINE Real mix(Real a, Real b, Real t) { return a + t * (b - a); }
HWY_INLINE Real3 mix(const Real3& a, const Real3& b, Real t) { return a + t * (b - a); }

// math/frame.h
struct RealFrame {
  Real3 tangent, bitangent, normal;

  HWY_INLINE Real3 to_local(const Real3& v) const {
    return {dot(v, tangent), dot(v, bitangent), dot(v, normal)};
  }
  HWY_INLINE Real3 to_world(const Real3& v) const {
    return v.x * tangent + v.y * bitangent + v.z * normal;
  }
};

HWY_INLINE RealFrame frame_around(const Real3& n) {
  const Real sign = select(n.z < 0.0f, -1.0f, 1.0f);
  const Real a = Real(-1.0f) / (sign + n.z);
  const Real b = n.x * n.y * a;
  return {{Real(1.0f) + sign * n.x * n.x * a, sign * b, -sign * n.x},
          {b, sign + n.y * n.y * a, -n.y},
          n};
}

HWY_INLINE RealFrame frame_along(const Real3& n, const Real3& tangent) {
  const Real3 t = tangent - dot(tangent, n) * n;
  const Real squared = dot(t, t);
  const Real3 unit = t / sqrt(squared);
  const Bool found = squared > 1e-12f;
  RealFrame frame = {unit, cross(n, unit), n};
  if (HWY_UNLIKELY(any(!found))) {
    const RealFrame around = frame_around(n);
    frame.tangent = select(found, frame.tangent, around.tangent);
    frame.bitangent = select(found, frame.bitangent, around.bitangent);
  }
  return frame;
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
