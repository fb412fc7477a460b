// LightKernels, some lanes at a time.
#include "math/sobol-inl.h"
#include "render/kernels/light_kernels.h"
#include "render/kernels/surface-inl.h"
#include "shading/bsdf_builder-inl.h"
#include "shading/environment-inl.h"

#if defined(DAPPLE_RENDER_LIGHT_PATHS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_RENDER_LIGHT_PATHS_INL_H
#undef DAPPLE_RENDER_LIGHT_PATHS_INL_H
#else
#define DAPPLE_RENDER_LIGHT_PATHS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

HWY_INLINE WordVec load_words(const std::uint32_t* words) { return hn::Load(Words(), words); }
HWY_INLINE void store(WordVec v, std::uint32_t* words) { hn::Store(v, Words(), words); }
HWY_INLINE void store(FloatVec v, float* floats) { hn::Store(v, Floats(), floats); }
HWY_INLINE FloatVec3 load_vectors(const float (&arrays)[3][kStride], std::size_t i) {
  return {load_floats(arrays[0] + i), load_floats(arrays[1] + i), load_floats(arrays[2] + i)};
}
HWY_INLINE void store(FloatVec3 v, float (&arrays)[3][kStride], std::size_t i) {
  store(v.x, arrays[0] + i);
  store(v.y, arrays[1] + i);
  store(v.z, arrays[2] + i);
}
HWY_INLINE void store(const UniformVec4& u, float (&arrays)[4][kStride], std::size_t i) {
  store(u.u0, arrays[0] + i);
  store(u.u1, arrays[1] + i);
  store(u.u2, arrays[2] + i);
  store(u.u3, arrays[3] + i);
}

// Puts zeros between the lower 16 bits.
HWY_INLINE WordVec spread_bits(WordVec x) {
  x = hn::And(x, all_words(0xffffu));
  x = hn::And(hn::Or(x, hn::ShiftLeft<8>(x)), all_words(0x00ff00ffu));
  x = hn::And(hn::Or(x, hn::ShiftLeft<4>(x)), all_words(0x0f0f0f0fu));
  x = hn::And(hn::Or(x, hn::ShiftLeft<2>(x)), all_words(0x33333333u));
  return hn::And(hn::Or(x, hn::ShiftLeft<1>(x)), all_words(0x55555555u));
}

struct PlaceVec {
  WordVec block, position;
};

// PathSampler::place.
HWY_INLINE PlaceVec sampler_place(const SamplerView& sampler, WordVec x, WordVec y,
                                  WordVec sample) {
  const WordVec low = all_words((1u << sampler.pixel_bits) - 1);
  const WordVec morton =
      hn::Or(spread_bits(hn::And(x, low)), hn::ShiftLeft<1>(spread_bits(hn::And(y, low))));
  const WordVec position = hn::Or(hn::ShiftLeftSame(morton, sampler.sample_bits), sample);
  const WordVec of_y = mix(hn::ShiftRightSame(y, sampler.pixel_bits), all_words(sampler.seed_high));
  const WordVec block = mix(hn::ShiftRightSame(x, sampler.pixel_bits), of_y);
  return {hn::Xor(block, all_words(sampler.seed_low)),
          reverse_bits(hn::ShiftLeftSame(position, 32 - sampler.bits()))};
}

// PixelFilter::place.
HWY_INLINE FloatVec filter_place(const FilterView& filter, FloatVec u) {
  if (filter.places == nullptr) return u;
  const FloatVec x = hn::Mul(u, all(static_cast<float>(filter.steps)));
  const WordVec step = to_words(x);
  const FloatVec rest = hn::Sub(x, to_floats(step));
  const FloatVec near = gather_floats(filter.places, step);
  const FloatVec next = gather_floats(filter.places, hn::Add(step, all_words(1)));
  return hn::Add(hn::Mul(hn::Sub(all(1.0f), rest), near), hn::Mul(rest, next));
}

HWY_ATTR void start_chunk(const SamplerView& sampler, const FilterView& filter,
                          const CameraFrame& camera, std::size_t count, StartChunk& chunk) {
  for (std::size_t i = 0; i < count; i += kLanes) {
    const WordVec x = load_words(chunk.x + i), y = load_words(chunk.y + i);
    const PlaceVec place = sampler_place(sampler, x, y, load_words(chunk.sample + i));
    const WordVec first = hn::Zero(Words());  // Decision::camera of the first vertex
    const UniformVec4 u = owen_sobol4(place.block, place.position, first, sampler.bits());
    // As CameraRays::generate, with a direction of unit length.
    const DiscPoint lens = sample_uniform_disc(u.u2, u.u3);
    const FloatVec3 offset = lens.x * all(camera.lens_u) + lens.y * all(camera.lens_v);
    const FloatVec column = hn::Add(to_floats(x), filter_place(filter, u.u0));
    const FloatVec row = hn::Add(to_floats(y), filter_place(filter, u.u1));
    const FloatVec3 target =
        all(camera.corner) + column * all(camera.per_column) + row * all(camera.per_row);
    FloatVec3 origin = all(camera.origin) + offset;
    FloatVec3 direction = target - offset;
    if (camera.orthographic) {
      origin = origin + (target - all(camera.forward));
      direction = all(camera.forward) - offset;
    }
    store(origin, chunk.origin, i);
    store(normalize(direction), chunk.direction, i);
    store(place.block, chunk.block + i);
    store(place.position, chunk.position + i);
    store(multiply_wide(mix(place.block, place.position), 3).high, chunk.channel + i);
  }
}

HWY_ATTR void draw_chunk(const SamplerView& sampler, std::size_t count, VertexChunk& chunk) {
  for (std::size_t i = 0; i < count; i += kLanes) {
    const WordVec block = load_words(chunk.block + i), position = load_words(chunk.position + i);
    const WordVec dimension = load_words(chunk.dimension + i);
    const WordVec next = hn::Add(dimension, all_words(1));
    store(owen_sobol4(block, position, dimension, sampler.bits()), chunk.choose, i);
    store(owen_sobol4(block, position, next, sampler.bits()), chunk.move, i);
  }
}

HWY_ATTR void sample_environment_chunk(const EnvironmentView& light, std::size_t count,
                                       VertexChunk& chunk) {
  for (std::size_t i = 0; i < count; i += kLanes) {
    const EnvironmentSampleVec found =
        sample_environment(light, load_floats(chunk.move[2] + i), load_floats(chunk.move[3] + i));
    store(found.direction, chunk.light_direction, i);
    store(found.radiance, chunk.light_radiance, i);
    store(found.pdf, chunk.light_pdf + i);
  }
}

HWY_ATTR void describe_chunk(const MeshView& mesh, std::size_t count, SurfaceChunk& chunk) {
  for (std::size_t i = 0; i < count; i += kLanes) describe_lanes(mesh, i, chunk);
}

HWY_ATTR void shade_chunk(const AlbedoPairs& tables, std::size_t count, BsdfChunk& chunk) {
  for (std::size_t i = 0; i < count; i += kLanes) shade_lanes(tables, i, chunk);
}

HWY_ATTR void see_environment_chunk(const EnvironmentView& light, std::size_t count,
                                    EscapeChunk& chunk) {
  for (std::size_t i = 0; i < count; i += kLanes) {
    const FloatVec3 direction = load_vectors(chunk.direction, i);
    const UvVec uv = environment_uv(light, direction);
    store(environment_lookup(light, uv), chunk.radiance, i);
    store(environment_pdf(light, uv, direction.y), chunk.pdf + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
