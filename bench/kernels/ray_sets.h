// The rays of the comparison: what a path tracer would ask in these scenes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kernels/tracer.h"
#include "util/error.h"

namespace dapple::bench {

struct RaySet {
  std::string name;
  Query query = Query::closest;
  std::vector<Ray> rays;
};

// Finds closest hits while the sets are made; which structure does it makes no difference.
using FindHits = std::function<std::vector<Found>(std::span<const Ray>)>;

// Sets of up to image_side^2 rays:
//   primary    through the pixels of a square picture, in blocks of 4 x 4 within tiles of 32 x 32
//   diffuse 1  cosine-distributed from where those hit, shuffled
//   diffuse 4  the fourth generation of such rays, shuffled
//   shadow     from where the primary rays hit to points of the scene's box stretched upwards
// An error when the camera sees nothing.
[[nodiscard]] Expected<std::vector<RaySet>> make_ray_sets(const SceneView& scene, int image_side,
                                                          const FindHits& find_hits);

}  // namespace dapple::bench
