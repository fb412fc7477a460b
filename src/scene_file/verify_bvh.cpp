#include "scene_file/verify_bvh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "parallel/parallel.h"
#include "scene/prims.h"

namespace dapple {
namespace {

constexpr int kWidth = kWideWidth;

int used_children(const WideNode& node) {
  int used = 0;
  while (used < kWidth && !node.children[used].empty()) ++used;
  return used;
}

bool rest_is_empty(const WideNode& node, int used) {
  for (int slot = used; slot < kWidth; ++slot) {
    if (!node.children[slot].empty()) return false;
    for (int axis = 0; axis < 3; ++axis) {
      if (node.lo[axis][slot] != Bounds3f::kInfinity) return false;
      if (node.hi[axis][slot] != -Bounds3f::kInfinity) return false;
    }
  }
  return true;
}

bool box_is_finite(const WideNode& node, int slot) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(node.lo[axis][slot]) || !std::isfinite(node.hi[axis][slot])) return false;
  }
  return true;
}

Bounds3f box_of(const WideNode& node, int slot) {
  return {{node.lo[0][slot], node.lo[1][slot], node.lo[2][slot]},
          {node.hi[0][slot], node.hi[1][slot], node.hi[2][slot]}};
}

// The number of lanes in use of a leaf that is known to be whole.
std::size_t count_of(const LeafRow* rows, LeafRef leaf) {
  const std::uint32_t* ids = rows[leaf.first_row() + leaf_id_row(leaf.kind())].words;
  std::size_t count = 0;
  while (count < kLeafWidth && ids[count] != kNoPrim) ++count;
  return count;
}

// A child that the walk has yet to come to.
struct Pending {
  std::uint64_t node;
  int depth;
};

// Of the world and of all prototypes.
std::size_t count_prims(const SceneView& scene) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < kShapeKindCount; ++k) count += scene.count(static_cast<ShapeKind>(k));
  return count;
}

}  // namespace

BvhVerifier::BvhVerifier(const WideBvhView& bvh, const SceneView& scene)
    : bvh_(bvh),
      scene_(scene),
      check_leaf_(leaf_checks().front()),
      first_ids_(first_prim_ids(scene)),
      prim_count_(count_prims(scene)),
      ids_(prim_count_) {
  lay_out_trees();
}

void BvhVerifier::lay_out_trees() {
  const auto first =
      static_cast<std::uint32_t>(first_ids_[static_cast<std::size_t>(ShapeKind::triangle)]);
  const auto in_world = static_cast<std::uint32_t>(scene_.object_count(ShapeKind::triangle));
  if (scene_.object_count() > 0) trees_.push_back({true, {first, in_world}});
  for (const Prototype& prototype : scene_.prototypes) {
    if (prototype.triangle_count == 0) continue;
    trees_.push_back({false, {first + prototype.first_triangle, prototype.triangle_count}});
  }
  if (trees_.empty()) trees_.push_back({true, {first, 0}});
  roots_.push_back(0);
  std::size_t pending = 1;
  for (std::size_t i = 0; i < bvh_.nodes.size() && roots_.size() < trees_.size(); ++i) {
    for (const ChildRef child : bvh_.nodes[i].children) pending += child.is_node();
    if (--pending != 0) continue;
    roots_.push_back(i + 1);
    pending = 1;
  }
}

const BvhVerifier::Tree& BvhVerifier::tree_of(std::size_t node) const {
  const auto after = std::upper_bound(roots_.begin(), roots_.end(), node);
  return trees_[static_cast<std::size_t>(after - roots_.begin()) - 1];
}

// Node after node, with the children still to come on a stack: what is on top must be the next
// node.
BvhDamage BvhVerifier::check_order() const {
  std::array<Pending, kMaxWideDepth * kWidth> stack;  // at each level all but one of the siblings
  std::size_t pending = 0;
  std::size_t next_row = 0;
  std::size_t tree_count = 0;
  for (std::size_t i = 0; i < bvh_.nodes.size(); ++i) {
    if (pending == 0) {
      if (tree_count++ == trees_.size()) return {i, "the node is not part of the tree"};
      stack[pending++] = {i, 1};
    }
    const Pending current = stack[--pending];
    if (current.node != i) return {i, "the node is not the next in depth-first order"};
    const auto& children = bvh_.nodes[i].children;
    for (int slot = 0; slot < kWidth; ++slot) {
      if (!children[slot].is_leaf()) continue;
      if (children[slot].leaf_row() != next_row) {
        return {i, "a leaf does not begin where the one before it ends"};
      }
      next_row += leaf_rows(children[slot].leaf_kind());
    }
    for (int slot = kWidth - 1; slot >= 0; --slot) {
      if (!children[slot].is_node()) continue;
      if (current.depth == kMaxWideDepth) return {i, "the tree is too deep"};
      stack[pending++] = {children[slot].node_index(), current.depth + 1};
    }
  }
  if (pending != 0) {
    return {bvh_.nodes.size() - 1, "a child after it is no node or is there twice"};
  }
  if (tree_count != trees_.size()) return {0, "the tree of a prototype is missing"};
  if (next_row != bvh_.rows.size()) return {0, "there are rows that belong to no leaf"};
  return {};
}

BvhDamage BvhVerifier::check_nodes(std::size_t begin, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (const char* reason = reason_against(i, count)) return {i, reason};
  }
  found_count_ += count;
  return {};
}

BvhDamage BvhVerifier::check_count() const {
  if (found_count_ == prim_count_) return {};
  return {0, "the number of primitives is not that of the scene"};
}

const char* BvhVerifier::reason_against(std::size_t index, std::size_t& count) const {
  const WideNode& node = bvh_.nodes[index];
  const int used = used_children(node);
  if (used == 0) return "the node has no children";
  if (!rest_is_empty(node, used)) return "an empty child is not empty or not last";
  const Tree& tree = tree_of(index);
  for (int slot = 0; slot < used; ++slot) {
    if (!box_is_finite(node, slot)) return "a box is not finite";
    const char* reason = node.children[slot].is_leaf()
                             ? reason_against_leaf(node, slot, tree, count)
                             : reason_against_inner(index, slot);
    if (reason != nullptr) return reason;
  }
  return nullptr;
}

// Empty children of the child have the empty box, which is inside every other.
const char* BvhVerifier::reason_against_inner(std::size_t index, int slot) const {
  const WideNode& node = bvh_.nodes[index];
  const std::uint64_t child_index = node.children[slot].node_index();
  if (child_index <= index || child_index >= bvh_.nodes.size()) {
    return "a child is not a node that comes later";
  }
  const WideNode& child = bvh_.nodes[child_index];
  unsigned outside = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float lo = node.lo[axis][slot];
    const float hi = node.hi[axis][slot];
    for (int i = 0; i < kWidth; ++i) {
      outside |= static_cast<unsigned>(!(child.lo[axis][i] >= lo)) |
                 static_cast<unsigned>(!(child.hi[axis][i] <= hi));
    }
  }
  return outside == 0 ? nullptr : "a child's box does not contain the boxes in it";
}

IdRange BvhVerifier::ids_of(const Tree& tree, ShapeKind kind) const {
  if (kind == ShapeKind::triangle) return tree.triangles;
  return {static_cast<std::uint32_t>(first_ids_[static_cast<std::size_t>(kind)]),
          static_cast<std::uint32_t>(scene_.count(kind))};
}

const char* BvhVerifier::reason_against_leaf(const WideNode& node, int slot, const Tree& tree,
                                             std::size_t& count) const {
  const ChildRef child = node.children[slot];
  const ShapeKind kind = child.leaf_kind();
  if (static_cast<std::size_t>(kind) >= kShapeKindCount) return "a leaf is of no known kind";
  if (!tree.world && kind != ShapeKind::triangle) {
    return "a leaf of a prototype does not hold triangles";
  }
  if (child.leaf_row() + leaf_rows(kind) > bvh_.rows.size()) {
    return "a leaf reaches beyond the last row";
  }
  const LeafRow* leaf = &bvh_.rows[child.leaf_row()];
  const LeafVerdict verdict = check_leaf_(kind, leaf, box_of(node, slot), ids_of(tree, kind));
  count += verdict.count;
  switch (verdict.fault) {
    case LeafFault::none:
      return nullptr;
    case LeafFault::empty:
      return "a leaf has no primitives";
    case LeafFault::order:
      return "a leaf's primitives are not first or not in order";
    case LeafFault::unused:
      return "a lane of a leaf that is not in use is not empty";
    case LeafFault::id:
      return "a primitive's id is not one of its kind";
    case LeafFault::coordinate:
      return "a coordinate in a leaf is not finite or too large";
    case LeafFault::box:
      return "a leaf's box does not contain its primitives";
  }
  return "a leaf is broken";
}

// Shapes are read in the order of leaves, which to the memory is no order.
void BvhVerifier::prefetch_shapes(const WideNode& node) const {
  for (const ChildRef child : node.children) {
    if (!child.is_leaf() || child.leaf_kind() != ShapeKind::sphere) continue;
    const LeafRow& ids = bvh_.rows[child.leaf_row() + leaf_id_row(ShapeKind::sphere)];
    for (const PrimId id : ids.words) {
      if (id != kNoPrim) __builtin_prefetch(&scene_.spheres[id]);
    }
  }
}

bool BvhVerifier::leaf_is_of_shapes(LeafRef leaf, IdSet::Bits& ids) const {
  std::array<LeafRow, kMaxLeafRows> expected;
  clear_leaf(leaf.kind(), expected.data());
  const std::size_t first = first_ids_[static_cast<std::size_t>(leaf.kind())];
  const std::size_t count = count_of(bvh_.rows.data(), leaf);
  for (std::size_t lane = 0; lane < count; ++lane) {
    const PrimId id = leaf_prim_id(bvh_.rows.data(), leaf.lane(lane));
    write_lane(scene_, prototype_boxes_, leaf.kind(), id - first, id, expected.data(), lane);
    IdSet::insert(ids, id);
  }
  const LeafRow* rows = &bvh_.rows[leaf.first_row()];
  return std::memcmp(rows, expected.data(), leaf_rows(leaf.kind()) * sizeof(LeafRow)) == 0;
}

BvhDamage BvhVerifier::check_shapes(std::size_t begin, std::size_t end) {
  std::call_once(boxes_made_, [&] { prototype_boxes_ = prototype_boxes(scene_); });
  IdSet::Bits ids = ids_.take();
  BvhDamage damage;
  for (std::size_t i = begin; i < end && damage.ok(); ++i) {
    prefetch_shapes(bvh_.nodes[i]);
    for (const ChildRef child : bvh_.nodes[i].children) {
      if (child.is_leaf() && !leaf_is_of_shapes(child.leaf_ref(), ids)) {
        damage = {i, "a primitive in a leaf is not the shape of that id"};
      }
    }
  }
  ids_.give_back(std::move(ids));
  return damage;
}

BvhDamage BvhVerifier::check_complete() const {
  if (ids_.is_full()) return {};
  return {0, "a shape is missing and another there twice"};
}

BvhDamage BvhVerifier::check_everything() {
  constexpr std::size_t kNodesAtOnce = 256;
  const std::size_t count = bvh_.nodes.size();
  const auto in_parallel = [&](auto check) -> BvhDamage {
    if (count <= kNodesAtOnce) return check(0, count);
    std::vector<BvhDamage> found((count + kNodesAtOnce - 1) / kNodesAtOnce);
    parallel_for_dynamic(found.size(), [&](std::size_t i) {
      found[i] = check(i * kNodesAtOnce, std::min((i + 1) * kNodesAtOnce, count));
    });
    const auto first = std::find_if(found.begin(), found.end(),
                                    [](const BvhDamage& damage) { return !damage.ok(); });
    return first == found.end() ? BvhDamage{} : *first;
  };
  const auto nodes = [&](std::size_t begin, std::size_t end) { return check_nodes(begin, end); };
  const auto shapes = [&](std::size_t begin, std::size_t end) { return check_shapes(begin, end); };
  BvhDamage damage = check_order();
  if (damage.ok()) damage = in_parallel(nodes);
  if (damage.ok()) damage = check_count();
  if (damage.ok()) damage = in_parallel(shapes);
  if (damage.ok()) damage = check_complete();
  return damage;
}

std::vector<std::size_t> BvhVerifier::cuts_by_rows(std::size_t rows_at_once) const {
  // The row at which the leaves of a node begin, or of the next node that has any.
  const auto first_row = [&](std::size_t index) {
    constexpr std::size_t kLookAhead = kMaxWideDepth;
    const std::size_t end = std::min(index + kLookAhead, bvh_.nodes.size());
    for (std::size_t i = index; i < end; ++i) {
      for (const ChildRef child : bvh_.nodes[i].children) {
        if (child.is_leaf()) return child.leaf_row();
      }
    }
    return bvh_.rows.size();
  };
  std::vector<std::size_t> cuts = {0};
  for (std::size_t row = rows_at_once; row < bvh_.rows.size(); row += rows_at_once) {
    std::size_t low = cuts.back();
    std::size_t high = bvh_.nodes.size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (first_row(middle) < row) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    cuts.push_back(low);
  }
  cuts.push_back(bvh_.nodes.size());
  return cuts;
}

}  // namespace dapple
