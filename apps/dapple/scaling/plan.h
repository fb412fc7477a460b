// What a scaling study measures.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "util/error.h"

namespace dapple::scaling {

enum class WorkKind {
  ray,      // rendering by brute force, as the program `ray`
  ray_bvh,  // rendering through the fast BVH, as `ray_bvh`
  build,    // building that BVH
};

// Strong scaling: the same work on more threads. Weak scaling: as much more work as threads.
enum class Mode { strong, weak };

[[nodiscard]] std::string_view work_name(WorkKind kind);
[[nodiscard]] std::string_view mode_name(Mode mode);
// What grows with the threads in weak scaling.
[[nodiscard]] std::string_view growth_name(WorkKind kind);
[[nodiscard]] Expected<WorkKind> parse_work(std::string_view name);

struct Configuration {
  WorkKind work = WorkKind::ray;
  int threads = 1;
  int factor = 1;  // times the work of one thread

  bool operator==(const Configuration&) const = default;
};

// What Configuration a point of a curve is.
[[nodiscard]] Configuration configuration_of(WorkKind work, Mode mode, int threads);

// Every configuration once: one thread serves both modes.
[[nodiscard]] std::vector<Configuration> make_plan(std::span<const WorkKind> works,
                                                   std::span<const int> threads);

// Ascending, without duplicates, and with 1, which all others are compared with.
[[nodiscard]] std::vector<int> tidy_thread_counts(std::vector<int> threads);
// 1, 2, 4, ... below `cores`, and `cores`.
[[nodiscard]] std::vector<int> default_thread_counts(int cores);

}  // namespace dapple::scaling
