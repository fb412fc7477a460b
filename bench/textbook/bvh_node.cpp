#include "textbook/bvh_node.h"

#include <algorithm>
#include <cmath>

namespace dapple::textbook {

Box surrounding(const Box& a, const Box& b) {
  return {{std::fmin(a.lo.x, b.lo.x), std::fmin(a.lo.y, b.lo.y), std::fmin(a.lo.z, b.lo.z)},
          {std::fmax(a.hi.x, b.hi.x), std::fmax(a.hi.y, b.hi.y), std::fmax(a.hi.z, b.hi.z)}};
}

BvhNode::BvhNode(std::span<const Hittable*> objects, int axis) {
  std::sort(objects.begin(), objects.end(), [axis](const Hittable* a, const Hittable* b) {
    return a->bounding_box().lo[axis] < b->bounding_box().lo[axis];
  });
  const std::size_t half = objects.size() / 2;
  left_ = make_child(objects.first(half), (axis + 1) % 3);
  right_ = make_child(objects.subspan(half), (axis + 1) % 3);
  box_ = surrounding(left_.target->bounding_box(), right_.target->bounding_box());
}

BvhNode::Child BvhNode::make_child(std::span<const Hittable*> objects, int axis) {
  if (objects.size() == 1) return {nullptr, objects.front()};
  Child child{std::make_unique<BvhNode>(objects, axis), nullptr};
  child.target = child.node.get();
  return child;
}

bool BvhNode::hit(const Ray& ray, double t_min, double t_max, HitRecord& record) const {
  if (!box_.hit(ray, t_min, t_max)) return false;
  const bool in_left = left_.target->hit(ray, t_min, t_max, record);
  const bool in_right = right_.target->hit(ray, t_min, in_left ? record.t : t_max, record);
  return in_left || in_right;
}

}  // namespace dapple::textbook
