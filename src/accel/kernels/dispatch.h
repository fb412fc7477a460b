// The one table of SIMD kernels, picked at start for the processor that runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "accel/hit.h"
#include "accel/placed_instance.h"
#include "math/ray.h"
#include "scene/scene_view.h"
#include "scene/wide_bvh.h"
#include "util/error.h"

namespace dapple {

// What the leaves hold that a ray meets before it enters an instance. Where that is known, kernels
// do without asking each leaf.
enum class LeafKinds {
  any,
  spheres,
  triangles,
  compact_any,  // with triangles in the compact form
  compact_triangles,
};
[[nodiscard]] constexpr bool is_compact(LeafKinds kinds) { return kinds >= LeafKinds::compact_any; }
[[nodiscard]] LeafKinds leaf_kinds(const SceneView& scene);

// The instances of a scene as a structure keeps them.
struct InstanceView {
  std::span<const PlacedInstance> instances;
  PrimId first_id = 0;
  LeafKinds kinds = LeafKinds::any;
};

// Leaves that every ray is tested against. The content of an instance is the prototype's number.
struct LinearView : InstanceView {
  std::span<const LeafRef> leaves;
  std::span<const std::span<const LeafRef>> prototypes;
  const LeafRow* rows = nullptr;
};

// The tree of the world begins at node 0, that of an instance where its content says.
struct WideView : InstanceView, WideBvhView {
  bool far = false;                  // more than the second-level cache holds
  std::span<const Vec3f> positions;  // of the scene's vertices, if the leaves are compact

  LeafArrays leaves() const {
    return {rows.data(), positions.data(), static_cast<std::uint32_t>(positions.size() - 1)};
  }
};

struct KernelTable {
  std::string_view isa;  // "avx512", "avx2", "sse4", "ssse3" or "portable"
  void (*intersect_wide)(const WideView&, const Ray*, Hit*, std::size_t);
  void (*occluded_wide)(const WideView&, const Ray*, std::uint8_t*, std::size_t);
  void (*intersect_linear)(const LinearView&, const Ray*, Hit*, std::size_t);
  void (*occluded_linear)(const LinearView&, const Ray*, std::uint8_t*, std::size_t);
};

// The best level of this processor, or the one that the environment variable DAPPLE_ISA names
// if the processor has it (an unknown or unavailable name is ignored; see check_isa_override).
[[nodiscard]] const KernelTable& kernels();

// Levels that this processor can run, best first.
[[nodiscard]] std::vector<std::string_view> available_isas();

// Uses that level from now on; not to be called while rays are being traced.
[[nodiscard]] Status force_isa(std::string_view isa);

// What is wrong with DAPPLE_ISA, if anything.
[[nodiscard]] Status check_isa_override();

}  // namespace dapple
