// Do two structures find the same hits, and if not, who is right?
#pragma once

#include <cstddef>

#include "kernels/ray_sets.h"

namespace dapple::bench {

struct Agreement {
  std::size_t same = 0;        // the same primitive at the same distance, or nothing, by both
  std::size_t borderline = 0;  // different, but within the error of single precision
  std::size_t a_wrong = 0;     // different, and double precision contradicts a
  std::size_t b_wrong = 0;
};

// `a` and `b` are what two structures found for the closest hits of `rays`.
[[nodiscard]] Agreement compare_closest(const SceneView& scene, std::span<const Ray> rays,
                                        std::span<const Found> a, std::span<const Found> b);

// `a` and `b` say whether anything was hit. Where they differ `find_a` and `find_b` are asked for
// the closest hits, which the referee then judges.
[[nodiscard]] Agreement compare_any(const SceneView& scene, std::span<const Ray> rays,
                                    std::span<const Found> a, std::span<const Found> b,
                                    const FindHits& find_a, const FindHits& find_b);

}  // namespace dapple::bench
