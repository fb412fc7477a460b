// The comparison of one scene on one number of cores.
#pragma once

#include <memory>
#include <vector>

#include "harness/report.h"
#include "kernels/ray_sets.h"
#include "kernels/tracer.h"

namespace dapple::bench {

using Contenders = std::vector<std::unique_ptr<Contender>>;  // dapple first

// Builds every contender's structure `rounds` times in turn; the last ones stay.
void compare_builds(const std::string& scene_name, const SceneView& scene,
                    const Contenders& contenders, Cores cores, int rounds, Report& report);

// Traces every ray set in every way, `rounds` times in turn. The structures must be built.
void compare_tracing(const std::string& scene_name, const std::vector<RaySet>& sets,
                     const Contenders& contenders, Cores cores, int rounds, Report& report);

// Whether the other contenders find what the first does, in every way they have.
void compare_hits(const std::string& scene_name, const SceneView& scene,
                  const std::vector<RaySet>& sets, const Contenders& contenders, Report& report);

}  // namespace dapple::bench
