// Rays prepared as prepare() of prepared_ray.h does, as many at once as a vector has lanes.
#include "accel/kernels/simd-inl.h"
#include "math/quads-inl.h"

#if defined(DAPPLE_KERNELS_PREPARE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PREPARE_INL_H
#undef DAPPLE_KERNELS_PREPARE_INL_H
#else
#define DAPPLE_KERNELS_PREPARE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct RayLanes {
  FloatVec origin[3], direction[3], inverse[3];
  FloatVec t_min, t_max, inverse_dot;
};

// The eight numbers of each of kLanes rays.
HWY_INLINE void load_numbers(const Ray* from, RayLanes& rays) {
  const Quads origins = load_quads([=](std::size_t i) { return &from[i].origin.x; });
  const Quads directions = load_quads([=](std::size_t i) { return &from[i].direction.x; });
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] = origins.of[axis];
    rays.direction[axis] = directions.of[axis];
  }
  rays.t_min = origins.of[3];
  rays.t_max = directions.of[3];
}

HWY_INLINE FloatVec squared_length(const FloatVec (&v)[3]) {
  return hn::Add(hn::Add(hn::Mul(v[0], v[0]), hn::Mul(v[1], v[1])), hn::Mul(v[2], v[2]));
}

HWY_INLINE RayLanes load_rays(const Ray* from) {
  const Floats d;
  const FloatVec zero = hn::Zero(d), smallest = all(kSmallestDirection);
  const FloatVec greatest = all(kLargestUsable);
  RayLanes rays;
  load_numbers(from, rays);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const FloatVec direction = rays.direction[axis];
    const FloatVec divisor = hn::IfThenElse(hn::Lt(hn::Abs(direction), smallest),
                                            hn::CopySign(smallest, direction), direction);
    rays.inverse[axis] = hn::Div(all(1.0f), divisor);
  }
  const FloatVec* o = rays.origin;
  const FloatVec origin_size = hn::Add(hn::Add(hn::Abs(o[0]), hn::Abs(o[1])), hn::Abs(o[2]));
  const FloatVec squared = squared_length(rays.direction);
  rays.inverse_dot = hn::Div(all(1.0f), squared);
  rays.t_min = hn::IfThenElse(hn::Gt(rays.t_min, zero), rays.t_min, zero);
  const FloatMask usable =
      hn::And(hn::And(hn::Gt(squared, zero), hn::Le(squared, greatest)),
              hn::And(hn::Le(origin_size, greatest), hn::Ge(rays.t_max, rays.t_min)));
  rays.t_max = hn::IfThenElse(usable, rays.t_max, all(-1.0f));
  return rays;
}

struct FrameLanes {
  WordVec axis;
  FloatVec shear[2];
};

HWY_INLINE FrameLanes frames_of(const RayLanes& rays) {
  const Words w;
  const FloatVec *v = rays.direction, *inverse = rays.inverse;
  const FloatVec x = hn::Abs(v[0]), y = hn::Abs(v[1]), z = hn::Abs(v[2]);
  const FloatMask x_first = hn::Ge(x, y);
  const FloatMask not_z = hn::Ge(hn::IfThenElse(x_first, x, y), z);
  // By the axis: x, y or z.
  const auto choose = [&](FloatVec of_x, FloatVec of_y, FloatVec of_z) {
    return hn::IfThenElse(not_z, hn::IfThenElse(x_first, of_x, of_y), of_z);
  };
  const WordVec of_xy = hn::IfThenElse(word_mask(x_first), hn::Zero(w), hn::Set(w, 1));
  const FloatVec along = choose(inverse[0], inverse[1], inverse[2]);
  return {hn::IfThenElse(word_mask(not_z), of_xy, hn::Set(w, 2)),
          {hn::Mul(choose(v[1], v[2], v[0]), along), hn::Mul(choose(v[2], v[0], v[1]), along)}};
}

// Rays that are prepared together and then taken one by one.
inline constexpr std::size_t kBatch = 16;

// In pieces of four words as PreparedRay has them; the last is the shear and the direction's signs,
// bit i for axis i where the ray goes down along it.
struct alignas(64) RayBatch {
  static constexpr std::size_t kPieces = 5;
  float pieces[kPieces][4 * kBatch];
};

template <bool kFrame>
HWY_INLINE void prepare_batch(const Ray* from, RayBatch& batch) {
  const Floats d;
  for (std::size_t i = 0; i < kBatch; i += kLanes) {
    const RayLanes rays = load_rays(from + i);
    const FloatVec *o = rays.origin, *v = rays.direction, *inverse = rays.inverse;
    FrameLanes frames = {hn::Zero(Words()), {hn::Zero(d), hn::Zero(d)}};
    if (kFrame) frames = frames_of(rays);
    const FloatVec pad = all(kFarPad);
    const auto sign = [&](std::size_t axis) {
      return hn::ShiftRight<31>(bits_of_floats(inverse[axis]));
    };
    const WordVec signs =
        hn::Or(hn::Or(sign(0), hn::ShiftLeft<1>(sign(1))), hn::ShiftLeft<2>(sign(2)));
    hn::StoreInterleaved4(o[0], o[1], o[2], rays.t_min, d, batch.pieces[0] + 4 * i);
    hn::StoreInterleaved4(v[0], v[1], v[2], rays.t_max, d, batch.pieces[1] + 4 * i);
    hn::StoreInterleaved4(inverse[0], inverse[1], inverse[2], rays.inverse_dot, d,
                          batch.pieces[2] + 4 * i);
    hn::StoreInterleaved4(hn::Mul(inverse[0], pad), hn::Mul(inverse[1], pad),
                          hn::Mul(inverse[2], pad), floats_of_bits(frames.axis), d,
                          batch.pieces[3] + 4 * i);
    hn::StoreInterleaved4(frames.shear[0], frames.shear[1], floats_of_bits(signs), hn::Zero(d), d,
                          batch.pieces[4] + 4 * i);
  }
}

// Ray i of a batch; returns the signs of its direction.
HWY_INLINE std::uint32_t take_ray(const RayBatch& batch, std::size_t i, PreparedRay& ray) {
  __builtin_memcpy(ray.origin, batch.pieces[0] + 4 * i, 16);
  __builtin_memcpy(ray.direction, batch.pieces[1] + 4 * i, 16);
  __builtin_memcpy(ray.inverse, batch.pieces[2] + 4 * i, 16);
  __builtin_memcpy(ray.inverse_far, batch.pieces[3] + 4 * i, 16);
  __builtin_memcpy(ray.shear, batch.pieces[4] + 4 * i, 8);
  std::uint32_t signs;
  __builtin_memcpy(&signs, batch.pieces[4] + 4 * i + 2, 4);
  return signs;
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
