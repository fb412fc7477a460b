// The stages of paths between traversals, for many paths at once: one table of functions for each
// instruction set, all of the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "accel/hit.h"
#include "accel/placed_instance.h"
#include "math/ray.h"
#include "render/camera_rays.h"
#include "render/film.h"
#include "shading/material_table.h"

namespace dapple {

// Samples [begin, end) of every pixel.
struct SampleRange {
  int begin = 0;
  int end = 0;
};

// What paths are started for together: at most kMostColumns by kMostRows pixels and kMostSamples
// samples of each.
struct PathUnit {
  Tile tile;
  SampleRange samples;
};

// The rays of 64 paths in a row go much the same way, which the traversal makes use of: paths start
// in strips of so many columns, all samples of a row (with 16 lanes, of two) before the next. With
// one sample these are squares.
inline constexpr std::uint32_t kStripColumns = 8;

// Which pixel and sample of its unit a path belongs to, in one word.
inline constexpr int kColumnBits = 12, kRowBits = 12, kSampleBits = 8;
inline constexpr int kMostColumns = 1 << kColumnBits, kMostRows = 1 << kRowBits;
inline constexpr int kMostSamples = 1 << kSampleBits;

// Paths in flight as arrays on 64-byte boundaries; element i of each belongs to path i. There is
// room for kPathPadding elements beyond all that were ever started, with finite numbers.
struct PathArrays {
  Ray* rays;
  Hit* hits;
  float* throughput[3];
  std::uint32_t* place;  // column, row and sample from the unit's first ones, lowest bits first
  std::size_t count;
};
inline constexpr std::size_t kPathPadding = 32;

// What hits are looked up in.
struct SurfaceView {
  LeafArrays leaves;
  const PlacedInstance* instances = nullptr;
  const PackedMaterial* materials = nullptr;
  std::size_t material_count = 0;
  std::array<const MaterialId*, kShapeKindCount> materials_of = {};
  std::array<PrimId, kShapeKindCount> first_ids = {};
};

struct PathKernels {
  std::string_view isa;  // as in accel/kernels/dispatch.h
  // Starts a path for each sample of each pixel.
  void (*start)(const CameraFrame&, const PathUnit&, std::uint64_t seed, PathArrays&);
  // Adds the sky to the film for paths that hit nothing, turns the others' rays into scattered ones
  // and drops those that were absorbed. The order of the paths changes.
  void (*scatter)(const SurfaceView&, const PathUnit&, std::uint32_t dimension, std::uint64_t seed,
                  PathArrays&, TileSums&);
  // Adds all paths' throughput to the film, as if they saw white.
  void (*cut)(const PathArrays&, TileSums&);
  // values[i] = sums[i] * scale.
  void (*average)(const std::int64_t* sums, std::size_t count, double scale, float* values);
};

// Those of the instruction set in use (see accel/kernels/dispatch.h).
[[nodiscard]] const PathKernels& path_kernels();

}  // namespace dapple
