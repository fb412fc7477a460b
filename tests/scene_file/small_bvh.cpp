#include "tests/scene_file/small_bvh.h"

#include <algorithm>

#include "scene/prims.h"

namespace dapple::test {
namespace {

struct Prim {
  ShapeKind kind;
  std::size_t index;
  PrimId id;
  Bounds3f box;
};

std::vector<Prim> prims_of_world(const SceneView& scene, const PrototypeBoxes& prototypes) {
  std::vector<Prim> prims;
  const auto first_ids = first_prim_ids(scene);
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    for (std::size_t i = 0; i < scene.object_count(kind); ++i) {
      const Bounds3f box = shape_bounds(scene, prototypes, kind, i);
      prims.push_back({kind, i, static_cast<PrimId>(first_ids[k] + i), box});
    }
  }
  return prims;
}

std::vector<Prim> prims_of(const SceneView& scene, const Prototype& prototype) {
  std::vector<Prim> prims;
  const std::size_t first = first_prim_ids(scene)[static_cast<std::size_t>(ShapeKind::triangle)];
  for (std::size_t i = 0; i < prototype.triangle_count; ++i) {
    const std::size_t index = prototype.first_triangle + i;
    prims.push_back({ShapeKind::triangle, index, static_cast<PrimId>(first + index),
                     triangle_bounds(scene, scene.triangles[index])});
  }
  return prims;
}

using Range = std::span<Prim>;

class Builder {
 public:
  Builder(const SceneView& scene, std::size_t max_children, std::size_t max_leaf)
      : scene_(scene),
        boxes_(prototype_boxes(scene)),
        max_children_(max_children),
        max_leaf_(max_leaf) {}

  SmallBvh build() {
    std::vector<Prim> prims = prims_of_world(scene_, boxes_);
    if (!prims.empty()) build_node(prims, 0);
    for (const Prototype& prototype : scene_.prototypes) {
      prims = prims_of(scene_, prototype);
      if (!prims.empty()) build_node(prims, 0);
    }
    return std::move(bvh_);
  }

 private:
  bool is_leaf(Range prims) const {
    return prims.size() <= max_leaf_ && std::all_of(prims.begin(), prims.end(), [&](const Prim& p) {
             return p.kind == prims.front().kind;
           });
  }

  std::vector<Range> split(Range prims, int axis) const {
    std::sort(prims.begin(), prims.end(), [&](const Prim& a, const Prim& b) {
      if (prims.size() <= max_leaf_) return std::pair(a.kind, a.id) < std::pair(b.kind, b.id);
      const float at_a = a.box.lo[axis] + a.box.hi[axis];
      const float at_b = b.box.lo[axis] + b.box.hi[axis];
      return std::pair(at_a, a.id) < std::pair(at_b, b.id);
    });
    const std::size_t parts = std::min(max_children_, prims.size());
    std::vector<Range> ranges;
    for (std::size_t i = 0; i < parts; ++i) {
      const std::size_t begin = prims.size() * i / parts;
      ranges.push_back(prims.subspan(begin, prims.size() * (i + 1) / parts - begin));
    }
    return ranges;
  }

  ChildRef add_leaf(Range prims) {
    std::sort(prims.begin(), prims.end(), [](const Prim& a, const Prim& b) { return a.id < b.id; });
    const ShapeKind kind = prims.front().kind;
    const std::size_t first_row = bvh_.rows.size();
    bvh_.rows.resize(first_row + leaf_rows(kind));
    clear_leaf(kind, &bvh_.rows[first_row]);
    for (std::size_t i = 0; i < prims.size(); ++i) {
      write_lane(scene_, boxes_, kind, prims[i].index, prims[i].id, &bvh_.rows[first_row], i);
    }
    return ChildRef::leaf(kind, first_row);
  }

  std::size_t add_node() {
    const std::size_t index = bvh_.nodes.size();
    WideNode& node = bvh_.nodes.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      std::fill_n(node.lo[axis], kWideWidth, Bounds3f::kInfinity);
      std::fill_n(node.hi[axis], kWideWidth, -Bounds3f::kInfinity);
    }
    return index;
  }

  // The node and its leaves first, then its inner children, one after the other.
  std::size_t build_node(Range prims, int axis) {
    const std::size_t index = add_node();
    const std::vector<Range> parts = is_leaf(prims) ? std::vector{prims} : split(prims, axis);
    for (std::size_t slot = 0; slot < parts.size(); ++slot) {
      Bounds3f box;
      for (const Prim& prim : parts[slot]) box.extend(prim.box);
      WideNode& node = bvh_.nodes[index];
      for (int a = 0; a < 3; ++a) {
        node.lo[a][slot] = box.lo[a];
        node.hi[a][slot] = box.hi[a];
      }
      if (is_leaf(parts[slot])) node.children[slot] = add_leaf(parts[slot]);
    }
    for (std::size_t slot = 0; slot < parts.size(); ++slot) {
      if (is_leaf(parts[slot])) continue;
      const std::size_t child = build_node(parts[slot], (axis + 1) % 3);
      bvh_.nodes[index].children[slot] = ChildRef::node(child);
    }
    return index;
  }

  const SceneView& scene_;
  PrototypeBoxes boxes_;
  std::size_t max_children_;
  std::size_t max_leaf_;
  SmallBvh bvh_;
};

}  // namespace

SmallBvh build_small_bvh(const SceneView& scene, std::size_t max_children, std::size_t max_leaf) {
  return Builder(scene, max_children, max_leaf).build();
}

}  // namespace dapple::test
