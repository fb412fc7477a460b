// The textbook BVH: binary, one object a leaf, split at the median along an axis that changes from
// level to level, every node allocated by itself, traversed by recursion.
#pragma once

#include <memory>
#include <span>

#include "textbook/hittable.h"

namespace dapple::textbook {

class BvhNode final : public Hittable {
 public:
  // Reorders `objects`, of which there are at least two; they must outlive the tree.
  BvhNode(std::span<const Hittable*> objects, int axis);

  bool hit(const Ray& ray, double t_min, double t_max, HitRecord& record) const override;
  Box bounding_box() const override { return box_; }

 private:
  // A child that is a node is owned here, one that is an object by the world.
  struct Child {
    std::unique_ptr<BvhNode> node;
    const Hittable* target = nullptr;
  };
  static Child make_child(std::span<const Hittable*> objects, int axis);

  Child left_, right_;
  Box box_;
};

}  // namespace dapple::textbook
