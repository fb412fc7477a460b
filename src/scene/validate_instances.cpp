#include "scene/validate_instances.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/validate.h"

namespace dapple {
namespace {

// Half the side of the cube around the origin that holds these vertices of a scene.
class Reach {
 public:
  explicit Reach(const SceneView& scene)
      : scene_(scene), of_prototypes_(scene.prototypes.size(), kUnknown) {
    for (const Vec3f& p : scene.vertices.positions)
      of_all_ = std::max(of_all_, max_abs_component(p));
  }

  float of_all() const { return of_all_; }
  float of(std::uint32_t prototype) {
    float& reach = of_prototypes_[prototype];
    if (reach == kUnknown) reach = compute(scene_.prototypes[prototype]);
    return reach;
  }

 private:
  static constexpr float kUnknown = -1;

  float compute(const Prototype& prototype) const {
    float reach = 0;
    for (const Triangle& triangle :
         scene_.triangles.subspan(prototype.first_triangle, prototype.triangle_count)) {
      for (const std::uint32_t v : triangle.vertices) {
        reach = std::max(reach, max_abs_component(scene_.vertices.positions[v]));
      }
    }
    return reach;
  }

  const SceneView& scene_;
  float of_all_ = 0;
  std::vector<float> of_prototypes_;
};

double reach_after(const Transformf& transform, double reach) {
  double most = 0;
  for (const auto& row : transform.rows) {
    const double linear =
        std::fabs(double{row[0]}) + std::fabs(double{row[1]}) + std::fabs(double{row[2]});
    most = std::max(most, linear * reach + std::fabs(double{row[3]}));
  }
  return most;
}

}  // namespace

bool is_valid(const Transformf& transform) {
  const auto all_are_small = [](const Transformd& m) {
    return std::all_of(&m.rows[0][0], &m.rows[0][0] + 12,
                       [](double x) { return std::fabs(x) <= kMaxCoordinate; });
  };
  const Transformd exact = to_double(transform);
  return all_are_small(exact) && determinant(exact) != 0 && all_are_small(inverse(exact));
}

std::optional<std::size_t> instance_too_far(const SceneView& scene) {
  if (scene.instances.empty()) return std::nullopt;
  Reach reach(scene);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (reach_after(instance.to_world, reach.of_all()) <= kMaxCoordinate) continue;
    if (!(reach_after(instance.to_world, reach.of(instance.prototype)) <= kMaxCoordinate)) return i;
  }
  return std::nullopt;
}

}  // namespace dapple
