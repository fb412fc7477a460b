#include "accel/wide_builder.h"

#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "accel/binary_tree.h"
#include "accel/placed_instance.h"
#include "accel/range_splitter.h"
#include "parallel/tasks.h"

namespace dapple {
namespace {

// A range up to this size is one task: a binary tree whose wide nodes are chosen together.
// At high quality more: only inside it are triangles split.
constexpr std::size_t task_prims(BvhQuality quality) {
  return std::size_t{1} << (quality == BvhQuality::high ? 15 : 13);
}
// What a tree of parts must save to be worth its memory: it is up to twice as large, and triangles
// are tested where parts of them are. At a seventh less camera rays were slower, all others little
// faster.
constexpr float kWorthSplitting = 0.85f;
// From this depth on larger ranges are split in half by number. With the halving of binary trees
// this keeps the deepest tree within kMaxWideDepth.
constexpr int kHalvingDepth = 10;

// The nodes and leaves of one task, numbered from 0. Either they are all below a binary tree's
// root; or there is one node, whose inner children are other tasks' fragments.
struct Fragment {
  std::vector<WideNode> nodes;
  std::vector<LeafRow> rows;
  std::vector<std::unique_ptr<Fragment>> children;
  std::size_t first_node = 0, first_row = 0;  // in the finished arrays
};

void set_box(WideNode& node, std::size_t i, const Bounds3f& box) {
  for (int axis = 0; axis < 3; ++axis) {
    node.lo[axis][i] = box.lo[axis];
    node.hi[axis][i] = box.hi[axis];
  }
}

std::size_t add_empty_node(Fragment& fragment) {
  WideNode& node = fragment.nodes.emplace_back();
  for (std::size_t i = 0; i < kWideWidth; ++i) set_box(node, i, Bounds3f{});
  return fragment.nodes.size() - 1;
}

ChildRef add_leaf(const RangeSplitter& splitter, const PrimRange& range, Fragment& fragment) {
  const ShapeKind kind = splitter.leaf_kind(range);
  const std::size_t first_row = fragment.rows.size();
  fragment.rows.resize(first_row + leaf_rows(kind, splitter.leaf_form()));
  splitter.write_leaf(range, fragment.rows.data() + first_row);
  return ChildRef::leaf(kind, first_row);
}

void add_nodes(const RangeSplitter& splitter, const BinaryTree& tree, BinaryTree::NodeId id,
               Fragment& fragment) {
  const std::size_t index = add_empty_node(fragment);
  const BinaryTree::Cut cut = tree.children(id);
  for (std::size_t i = 0; i < cut.count; ++i) {
    set_box(fragment.nodes[index], i, tree.range(cut.nodes[i]).box.bounds());
    if (!tree.is_leaf(cut.nodes[i])) continue;
    fragment.nodes[index].children[i] = add_leaf(splitter, tree.range(cut.nodes[i]), fragment);
  }
  for (std::size_t i = 0; i < cut.count; ++i) {
    if (tree.is_leaf(cut.nodes[i])) continue;
    fragment.nodes[index].children[i] = ChildRef::node(fragment.nodes.size());
    add_nodes(splitter, tree, cut.nodes[i], fragment);
  }
}

void add_tree(const RangeSplitter& splitter, const BinaryTree& tree, Fragment& fragment) {
  fragment.rows.reserve(tree.leaf_count() * kMaxLeafRows);
  fragment.nodes.reserve(tree.leaf_count() / 8 + 8);
  add_nodes(splitter, tree, BinaryTree::kRoot, fragment);
}

class Builder {
 public:
  Builder(const SceneView& scene, const PrototypeBoxes& prototypes, HugeArray<BuildPrim> prims,
          BvhQuality quality, LeafForm form, TriangleParts parts)
      : splitter_(scene, prototypes, std::move(prims), quality, form), quality_(quality) {
    whole_ = splitter_.whole();
    const bool may_split = parts == TriangleParts::where_they_pay && quality == BvhQuality::high;
    if (may_split) clipper_.emplace(scene, whole_.box.bounds());
  }

  // Splits the child with the largest surface until there are kWideWidth or only small ones.
  void build_top(const PrimRange& range, int depth, Fragment& fragment);

  const PrimRange& whole() const { return whole_; }

 private:
  std::vector<PrimRange> split_into_children(const PrimRange& range, int depth);
  void build_small(const PrimRange& range, Fragment& fragment);

  RangeSplitter splitter_;
  BvhQuality quality_;
  PrimRange whole_;
  std::optional<TriangleClipper> clipper_;  // where triangles may be split
};

std::vector<PrimRange> Builder::split_into_children(const PrimRange& range, int depth) {
  const SplitBy by = depth < kHalvingDepth ? SplitBy::sah : SplitBy::number;
  std::vector<PrimRange> children = {range};
  while (children.size() < kWideWidth) {
    PrimRange* largest = nullptr;
    for (PrimRange& child : children) {
      if (splitter_.is_leaf(child)) continue;
      if (largest == nullptr || child.box.half_area() > largest->box.half_area()) largest = &child;
    }
    if (largest == nullptr) break;
    const auto [left, right] = splitter_.split(*largest, by);
    *largest = left;
    children.push_back(right);
  }
  return children;
}

// A volume full of leaves side by side makes a ray visit about the cube root of their number. Where
// it is a quarter more, leaves overlap, and smaller parts may part them.
bool overlaps(const BinaryTree& tree) {
  const double visits = double{tree.cost()} / double{tree.range(BinaryTree::kRoot).box.half_area()};
  return visits * visits * visits > 2 * static_cast<double>(tree.leaf_count());
}

// Splitting triangles pays in some places only: it is tried, and the better tree taken.
void Builder::build_small(const PrimRange& range, Fragment& fragment) {
  const BinaryTree tree(splitter_, range, quality_);
  if (clipper_ && overlaps(tree) && splitter_.can_split_any(range, *clipper_)) {
    RangeSplitter parts = splitter_.with_room(range, *clipper_);
    const BinaryTree of_parts(parts, parts.whole(), quality_);
    if (of_parts.cost() < kWorthSplitting * tree.cost()) {
      add_tree(parts, of_parts, fragment);
      return;
    }
  }
  add_tree(splitter_, tree, fragment);
}

void Builder::build_top(const PrimRange& range, int depth, Fragment& fragment) {
  if (range.size() <= task_prims(quality_) && !(depth == 0 && splitter_.is_leaf(range))) {
    build_small(range, fragment);
    splitter_.forget(range);
    return;
  }
  const std::vector<PrimRange> children = split_into_children(range, depth);
  const std::size_t index = add_empty_node(fragment);
  TaskGroup tasks;
  for (std::size_t i = 0; i < children.size(); ++i) {
    set_box(fragment.nodes[index], i, children[i].box.bounds());
    if (splitter_.is_leaf(children[i])) {
      fragment.nodes[index].children[i] = add_leaf(splitter_, children[i], fragment);
      continue;
    }
    fragment.nodes[index].children[i] = ChildRef::node(fragment.children.size());
    Fragment* child = fragment.children.emplace_back(std::make_unique<Fragment>()).get();
    tasks.run([this, below = children[i], depth, child] { build_top(below, depth + 1, *child); });
  }
  tasks.wait();
}

// Joins the fragments, tree after tree and depth first, into the finished arrays.
class Joiner {
 public:
  // After compact leaves stands a row of zeros: some kernels read the fifth row of any leaf.
  Joiner(std::vector<Fragment>& roots, LeafForm form, bool gives_back)
      : form_(form), gives_back_(gives_back), spare_rows_(form == LeafForm::compact ? 1 : 0) {
    for (Fragment& root : roots) place(root);
  }

  // Takes the fragments apart while it copies them, so that they and the result are never there
  // whole at the same time.
  WideBvh join() const {
    if (row_count_ > ChildRef::kMaxRow)
      throw std::length_error("the leaves of the BVH pass 16 GiB");
    WideBvh bvh{HugeArray<WideNode>(node_count_), HugeArray<LeafRow>(row_count_ + spare_rows_),
                form_};
    parallel_for_chunks(fragments_.size(), 1,
                        [&](std::size_t i, std::size_t) { take(*fragments_[i], bvh); });
    return bvh;
  }

 private:
  void place(Fragment& fragment) {
    fragments_.push_back(&fragment);
    fragment.first_node = node_count_;
    fragment.first_row = row_count_;
    node_count_ += fragment.nodes.size();
    row_count_ += fragment.rows.size();
    for (const auto& child : fragment.children) place(*child);
  }

  static ChildRef moved(ChildRef child, const Fragment& fragment) {
    if (child.empty()) return child;
    if (child.is_leaf()) {
      return ChildRef::leaf(child.leaf_kind(), child.leaf_row() + fragment.first_row);
    }
    if (fragment.children.empty()) {
      return ChildRef::node(child.node_index() + fragment.first_node);
    }
    return ChildRef::node(fragment.children[child.node_index()]->first_node);
  }

  void take(Fragment& fragment, WideBvh& bvh) const {
    std::copy(fragment.rows.begin(), fragment.rows.end(), bvh.rows.data() + fragment.first_row);
    WideNode* to = bvh.nodes.data() + fragment.first_node;
    for (const WideNode& node : fragment.nodes) {
      *to = node;
      for (ChildRef& child : to->children) child = moved(child, fragment);
      ++to;
    }
    // An allocator would keep the memory for later; in a large build the result needs it now.
    if (gives_back_) forget_pages(fragment.rows.data(), fragment.rows.size() * sizeof(LeafRow));
    fragment.rows = {};
    fragment.nodes = {};
  }

  LeafForm form_;
  bool gives_back_;
  std::size_t spare_rows_;
  std::vector<Fragment*> fragments_;
  std::size_t node_count_ = 0, row_count_ = 0;
};

// What there is to build: the tree of the world, then those of the prototypes.
std::vector<Fragment> build_trees(const SceneView& scene, BvhQuality quality, LeafForm form,
                                  TriangleParts parts) {
  const PrototypeBoxes boxes = prototype_boxes(scene);
  std::vector<Fragment> roots(1 + scene.prototypes.size());
  const auto build = [&](HugeArray<BuildPrim> prims, Fragment& root) {
    if (prims.size() == 0) return;
    Builder builder(scene, boxes, std::move(prims), quality, form, parts);
    builder.build_top(builder.whole(), 0, root);
  };
  TaskGroup tasks;
  for (std::size_t i = 0; i < scene.prototypes.size(); ++i) {
    tasks.run([&, i] { build(make_prototype_prims(scene, scene.prototypes[i]), roots[1 + i]); });
  }
  build(make_build_prims(scene, boxes), roots[0]);
  tasks.wait();
  return roots;
}

}  // namespace

WideBvh build_wide_bvh(const SceneView& scene, ThreadTimes* times, BvhQuality quality,
                       LeafForm form, TriangleParts parts) {
  WideBvh bvh;
  const auto build = [&] {
    std::vector<Fragment> roots = build_trees(scene, quality, form, parts);
    const std::size_t count = scene.object_count() + scene.triangles.size();
    bvh = Joiner(roots, form, count >= kGivesBackFrom).join();
  };
  run_with_tasks(scene.object_count() + scene.triangles.size(), build, times);
  return bvh;
}

std::vector<std::uint32_t> tree_roots(std::span<const WideNode> nodes) {
  std::vector<std::uint32_t> roots;
  std::size_t pending = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (pending == 0) {
      roots.push_back(static_cast<std::uint32_t>(i));
      ++pending;
    }
    --pending;
    for (const ChildRef child : nodes[i].children) pending += child.is_node();
  }
  return roots;
}

std::vector<std::uint32_t> prototype_roots(const SceneView& scene,
                                           std::span<const WideNode> nodes) {
  const std::vector<std::uint32_t> roots = tree_roots(nodes);
  std::size_t next = scene.object_count() == 0 ? 0 : 1;
  std::vector<std::uint32_t> of_prototypes;
  for (const Prototype& prototype : scene.prototypes) {
    of_prototypes.push_back(prototype.triangle_count == 0 ? PlacedInstance::kNothing
                                                          : roots[next++]);
  }
  return of_prototypes;
}

}  // namespace dapple
