// What is run: the classic renderings and BVH construction.
#pragma once

#include <memory>

#include "dapple/scaling/plan.h"
#include "dapple/scaling/sample.h"
#include "render/settings.h"
#include "scene/scene_view.h"

namespace dapple::scaling {

class Workload {
 public:
  virtual ~Workload() = default;

  virtual WorkKind kind() const = 0;
  // Makes what run(factor) needs, so that the run measures nothing else.
  [[nodiscard]] virtual Status prepare(int factor) = 0;
  // Does `factor` times the work of one thread, on as many threads as are set.
  [[nodiscard]] virtual Expected<Sample> run(int factor) = 0;
};

// `kind` says how hits are found; samples per pixel grow with the factor, so that every pixel and
// every path is as likely as before and the work grows exactly. The view must outlive it.
[[nodiscard]] std::unique_ptr<Workload> make_rendering(WorkKind kind, const SceneView& scene,
                                                       const RenderSettings& settings);

// The cloud of so many spheres; the objects grow with the factor. Sorting them costs n log n, so
// that even without any loss the time grows with the logarithm.
[[nodiscard]] std::unique_ptr<Workload> make_building(int objects);

}  // namespace dapple::scaling
