// What light paths do many at once between traversals: one table of functions for each instruction
// set, all of the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render/camera_rays.h"
#include "render/kernels/sampling_views.h"
#include "render/kernels/surface_chunk.h"
#include "shading/albedo_tables.h"
#include "shading/bsdf_chunk.h"
#include "shading/environment_view.h"

namespace dapple {

// Structures of arrays: element i of each belongs to one path. Beyond those in use there are
// numbers left from before, or zeros.

// Paths that start.
struct alignas(64) StartChunk {
  std::uint32_t x[kStride] = {}, y[kStride] = {}, sample[kStride] = {};
  // What is found for them: places in the sampler's sequences, rays, and a channel of dispersion.
  std::uint32_t block[kStride] = {}, position[kStride] = {}, channel[kStride] = {};
  float origin[3][kStride] = {}, direction[3][kStride] = {};
};

// Paths at vertices, before these are known: random numbers do not depend on them.
struct alignas(64) VertexChunk {
  std::uint32_t block[kStride] = {}, position[kStride] = {}, dimension[kStride] = {};
  // Of that dimension and the next.
  float choose[4][kStride] = {}, move[4][kStride] = {};
  // The light that the environment gives for the last two of them.
  float light_direction[3][kStride] = {}, light_radiance[3][kStride] = {}, light_pdf[kStride] = {};
};

// Paths that leave the scene.
struct alignas(64) EscapeChunk {
  float direction[3][kStride] = {};
  float radiance[3][kStride] = {}, pdf[kStride] = {};  // of the environment there
};

struct LightKernels {
  std::string_view isa;  // as in accel/kernels/dispatch.h
  // Each for the first `count` elements.
  void (*start)(const SamplerView&, const FilterView&, const CameraFrame&, std::size_t count,
                StartChunk&);
  void (*draw)(const SamplerView&, std::size_t count, VertexChunk&);
  void (*sample_environment)(const EnvironmentView&, std::size_t count, VertexChunk&);
  // Describes the surface of each hit.
  void (*describe)(const MeshView&, std::size_t count, SurfaceChunk&);
  // Makes, evaluates and samples the Bsdf of each point.
  void (*shade)(const AlbedoPairs&, std::size_t count, BsdfChunk&);
  void (*see_environment)(const EnvironmentView&, std::size_t count, EscapeChunk&);
};

// Those of the instruction set in use (see accel/kernels/dispatch.h).
[[nodiscard]] const LightKernels& light_kernels();

}  // namespace dapple
