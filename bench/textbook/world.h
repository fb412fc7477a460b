// A scene as a list of objects, with or without its tree.
#pragma once

#include <memory>
#include <vector>

#include "scene/scene_view.h"
#include "textbook/bvh_node.h"

namespace dapple::textbook {

// The scene's materials must outlive the world.
class World {
 public:
  explicit World(const SceneView& scene);

  void build_tree();
  // Through the tree; a world of fewer than two objects has none and tests what there is.
  bool hit(const Ray& ray, double t_min, double t_max, HitRecord& record) const {
    if (root_ != nullptr) return root_->hit(ray, t_min, t_max, record);
    return !objects_.empty() && objects_.front()->hit(ray, t_min, t_max, record);
  }

 private:
  std::vector<std::unique_ptr<Hittable>> objects_;
  std::unique_ptr<BvhNode> root_;
};

}  // namespace dapple::textbook
