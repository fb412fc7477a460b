// Proof of a stored BVH.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "scene/prims.h"
#include "scene_file/id_set.h"
#include "scene_file/leaf_check.h"

namespace dapple {

// What is wrong with a BVH, and at which node; ok() when nothing is.
struct BvhDamage {
  static constexpr std::size_t kNowhere = ~std::size_t{0};
  std::size_t node = kNowhere;
  const char* reason = nullptr;

  bool ok() const { return reason == nullptr; }
};

// check_order and check_nodes are independent of each other and neither trusts the other, so they
// can run at the same time. When both have passed for all nodes the tree is whole and safe to
// traverse, and only then the rest may be asked: whether it is the tree of these shapes.
class BvhVerifier {
 public:
  // The scene is asked for its counts; only check_shapes reads its shapes.
  BvhVerifier(const WideBvhView& bvh, const SceneView& scene);

  // There is a tree for the world and for each prototype that has triangles, one after the other.
  // Each node is reached exactly once, in depth-first order; leaves tile the rows in the order of
  // their nodes; no path is longer than kMaxWideDepth.
  BvhDamage check_order() const;

  // Of nodes [begin, end): used children first, references inside the arrays, boxes around all
  // that is in them, coordinates in range, ids of the right kind. Counts primitives.
  BvhDamage check_nodes(std::size_t begin, std::size_t end);
  // After check_nodes of all nodes: there are as many primitives as the scene has.
  BvhDamage check_count() const;

  // Of nodes [begin, end): primitives in the leaves are the scene's shapes in single precision.
  // Remembers which.
  BvhDamage check_shapes(std::size_t begin, std::size_t end);
  // After check_shapes of all nodes: each shape is in the tree, which, their number being right,
  // means once.
  BvhDamage check_complete() const;

  // All of the above, one after the other, each in parallel.
  BvhDamage check_everything();

  // Where to cut the nodes so that part k has the leaves of rows from k * rows_at_once on: part k
  // is [cuts[k], cuts[k + 1]). Cuts of a broken tree are in order too, but mean nothing.
  std::vector<std::size_t> cuts_by_rows(std::size_t rows_at_once) const;

 private:
  // One of the trees: what stands in the world, or the triangles of a prototype.
  struct Tree {
    bool world = true;
    IdRange triangles;  // that belong in it
  };

  // These add the primitives that they find to `count`.
  const char* reason_against(std::size_t index, std::size_t& count) const;
  const char* reason_against_leaf(const WideNode& node, int slot, const Tree& tree,
                                  std::size_t& count) const;
  const char* reason_against_inner(std::size_t index, int slot) const;
  bool leaf_is_of_shapes(LeafRef leaf, IdSet::Bits& ids) const;
  void lay_out_trees();
  const Tree& tree_of(std::size_t node) const;
  IdRange ids_of(const Tree& tree, ShapeKind kind) const;
  void prefetch_shapes(const WideNode& node) const;

  WideBvhView bvh_;
  const SceneView& scene_;
  LeafCheck check_leaf_;
  std::array<std::size_t, kShapeKindCount> first_ids_;
  PrototypeBoxes prototype_boxes_;  // made when shapes are first read
  std::once_flag boxes_made_;
  std::size_t prim_count_ = 0;
  std::vector<Tree> trees_;
  std::vector<std::size_t>
      roots_;  // where the nodes of the trees begin; means nothing in a bad file
  IdSet ids_;
  std::atomic<std::size_t> found_count_{0};
};

}  // namespace dapple
