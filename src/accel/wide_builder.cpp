#include "accel/wide_builder.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "accel/partition.h"
#include "accel/sah_split.h"
#include "parallel/tasks.h"
#include "scene/prims.h"

namespace dapple {
namespace {

// Subtrees above this size are tasks of their own.
constexpr std::size_t kTaskPrims = std::size_t{1} << 13;
// From this depth on, ranges are split in half by number, so that kMaxWideDepth is never reached:
// 2^31 primitives in leaves of 1 are 8 levels of 16 children.
constexpr int kHalvingDepth = 32;

// The nodes and leaves of one task, numbered from 0; subtrees built by other tasks hang below
// the first node.
struct Fragment {
  std::vector<WideNode> nodes;
  std::vector<LeafRow> rows;
  std::vector<std::unique_ptr<Fragment>> children;  // in the order of the first node's tagged refs
  std::size_t first_node = 0, first_row = 0;        // in the finished arrays
};

// The children of a node while it is being built.
struct Children {
  std::array<PrimRange, kWideWidth> ranges;
  std::size_t count = 0;

  std::span<const PrimRange> used() const { return {ranges.data(), count}; }
};

class Builder {
 public:
  Builder(const SceneView& scene)
      : scene_(scene),
        first_ids_(first_prim_ids(scene)),
        prims_(make_build_prims(scene)),
        scratch_(prims_.size() > kParallelRange ? prims_.size() : 0) {}

  WideBvh build();

 private:
  ShapeKind kind_of(PrimId id) const;
  bool is_leaf(const PrimRange& range) const;
  RangePair split(const PrimRange& range, int depth);
  RangePair split_by_id(const PrimRange& range);
  RangePair cut(const PrimRange& range, std::size_t middle) const;
  Children split_into_children(const PrimRange& range, int depth);

  ChildRef write_leaf(const PrimRange& range, Fragment& fragment) const;
  std::size_t start_node(const Children& children, Fragment& fragment) const;
  void build_serially(const PrimRange& range, int depth, Fragment& fragment);
  void build_fragment(const PrimRange& range, int depth, Fragment& fragment);

  const SceneView& scene_;
  std::array<std::size_t, kShapeKindCount> first_ids_;
  HugeArray<BuildPrim> prims_;
  HugeArray<BuildPrim> scratch_;
};

ShapeKind Builder::kind_of(PrimId id) const {
  std::size_t kind = kShapeKindCount - 1;
  while (id < first_ids_[kind]) --kind;
  return static_cast<ShapeKind>(kind);
}

// A leaf holds one kind of shape.
bool Builder::is_leaf(const PrimRange& range) const {
  if (range.size() > kLeafWidth) return false;
  const ShapeKind kind = kind_of(prims_[range.begin].id);
  for (std::size_t i = range.begin + 1; i < range.end; ++i) {
    if (kind_of(prims_[i].id) != kind) return false;
  }
  return true;
}

RangePair Builder::cut(const PrimRange& range, std::size_t middle) const {
  return {measure_range(prims_.span(), range.begin, middle),
          measure_range(prims_.span(), middle, range.end)};
}

// In half by id, or where the kind changes when that is within one leaf's worth.
RangePair Builder::split_by_id(const PrimRange& range) {
  const auto begin = prims_.data() + range.begin, end = prims_.data() + range.end;
  const auto by_id = [](const BuildPrim& a, const BuildPrim& b) { return a.id < b.id; };
  if (range.size() > kLeafWidth) {
    const auto middle = begin + range.size() / 2;
    std::nth_element(begin, middle, end, by_id);
    return cut(range, static_cast<std::size_t>(middle - prims_.data()));
  }
  std::sort(begin, end, by_id);
  const ShapeKind kind = kind_of(begin->id);
  const auto change =
      std::find_if(begin, end, [&](const BuildPrim& prim) { return kind_of(prim.id) != kind; });
  return cut(range, static_cast<std::size_t>(change - prims_.data()));
}

RangePair Builder::split(const PrimRange& range, int depth) {
  if (range.size() <= kLeafWidth || depth >= kHalvingDepth) return split_by_id(range);
  const auto best = find_sah_split(prims_.span(), range);
  if (!best) return split_by_id(range);
  return partition_range(prims_.span(), scratch_.span(), range, *best);
}

Children Builder::split_into_children(const PrimRange& range, int depth) {
  Children children;
  children.ranges[0] = range;
  children.count = 1;
  while (children.count < kWideWidth) {
    PrimRange* largest = nullptr;
    float largest_area = -1;
    for (std::size_t i = 0; i < children.count; ++i) {
      const float area = children.ranges[i].box.half_area();
      if (area > largest_area && !is_leaf(children.ranges[i])) {
        largest = &children.ranges[i];
        largest_area = area;
      }
    }
    if (largest == nullptr) break;
    const auto [left, right] = split(*largest, depth);
    *largest = left;
    children.ranges[children.count++] = right;
  }
  return children;
}

ChildRef Builder::write_leaf(const PrimRange& range, Fragment& fragment) const {
  std::array<PrimId, kLeafWidth> ids;
  for (std::size_t i = 0; i < range.size(); ++i) ids[i] = prims_[range.begin + i].id;
  std::sort(ids.begin(), ids.begin() + range.size());
  const ShapeKind kind = kind_of(ids[0]);
  const std::size_t first_row = fragment.rows.size();
  fragment.rows.resize(first_row + leaf_rows(kind));
  LeafRow* leaf = fragment.rows.data() + first_row;
  clear_leaf(kind, leaf);
  const std::size_t first_id = first_ids_[static_cast<std::size_t>(kind)];
  for (std::size_t i = 0; i < range.size(); ++i) {
    write_lane(scene_, kind, ids[i] - first_id, ids[i], leaf, i);
  }
  return ChildRef::leaf(kind, first_row);
}

// Adds a node with the boxes of its children and with its leaves; inner children come later.
std::size_t Builder::start_node(const Children& children, Fragment& fragment) const {
  const std::size_t index = fragment.nodes.size();
  WideNode& node = fragment.nodes.emplace_back();
  for (std::size_t i = 0; i < kWideWidth; ++i) {
    const Bounds3f box = i < children.count ? children.ranges[i].box.bounds() : Bounds3f{};
    for (int axis = 0; axis < 3; ++axis) {
      node.lo[axis][i] = box.lo[axis];
      node.hi[axis][i] = box.hi[axis];
    }
    node.children[i] = {};
    if (i < children.count && is_leaf(children.ranges[i])) {
      node.children[i] = write_leaf(children.ranges[i], fragment);
    }
  }
  return index;
}

void Builder::build_serially(const PrimRange& range, int depth, Fragment& fragment) {
  const Children children = split_into_children(range, depth);
  const std::size_t index = start_node(children, fragment);
  for (std::size_t i = 0; i < children.count; ++i) {
    if (is_leaf(children.ranges[i])) continue;
    fragment.nodes[index].children[i] = ChildRef::node(fragment.nodes.size());
    build_serially(children.ranges[i], depth + 1, fragment);
  }
}

void Builder::build_fragment(const PrimRange& range, int depth, Fragment& fragment) {
  if (range.size() <= kTaskPrims) {
    build_serially(range, depth, fragment);
    return;
  }
  const Children children = split_into_children(range, depth);
  start_node(children, fragment);
  TaskGroup tasks;
  for (std::size_t i = 0; i < children.count; ++i) {
    if (is_leaf(children.ranges[i])) continue;
    Fragment* child = fragment.children.emplace_back(std::make_unique<Fragment>()).get();
    fragment.nodes[0].children[i] = ChildRef::node(fragment.children.size() - 1);
    tasks.run([this, range_of_child = children.ranges[i], depth, child] {
      build_fragment(range_of_child, depth + 1, *child);
    });
  }
  tasks.wait();
}

// Joins the fragments, depth first, into the finished arrays.
class Joiner {
 public:
  explicit Joiner(Fragment& root) { place(root); }

  WideBvh join() {
    WideBvh bvh{HugeArray<WideNode>(node_count_), HugeArray<LeafRow>(row_count_)};
    parallel_for_chunks(fragments_.size(), 1,
                        [&](std::size_t i, std::size_t) { copy(*fragments_[i], bvh); });
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
    if (child.is_leaf())
      return ChildRef::leaf(child.leaf_kind(), child.leaf_row() + fragment.first_row);
    if (fragment.children.empty()) {
      return ChildRef::node(child.node_index() + fragment.first_node);
    }
    return ChildRef::node(fragment.children[child.node_index()]->first_node);
  }

  static void copy(const Fragment& fragment, WideBvh& bvh) {
    std::copy(fragment.rows.begin(), fragment.rows.end(), bvh.rows.data() + fragment.first_row);
    WideNode* to = bvh.nodes.data() + fragment.first_node;
    for (const WideNode& node : fragment.nodes) {
      *to = node;
      for (ChildRef& child : to->children) child = moved(child, fragment);
      ++to;
    }
  }

  std::vector<const Fragment*> fragments_;
  std::size_t node_count_ = 0, row_count_ = 0;
};

WideBvh Builder::build() {
  if (prims_.size() == 0) return {};
  Fragment root;
  build_fragment(measure_range(prims_.span(), 0, prims_.size()), 0, root);
  return Joiner(root).join();
}

}  // namespace

WideBvh build_wide_bvh(const SceneView& scene) {
  WideBvh bvh;
  run_with_tasks([&] { bvh = Builder(scene).build(); });
  return bvh;
}

}  // namespace dapple
