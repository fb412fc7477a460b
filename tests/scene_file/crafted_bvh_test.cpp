// Files with a broken BVH inside, checksums all right: each check on its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/scene_file/crafted_bvh.h"

namespace dapple {
namespace {

TEST_F(CraftedBvh, UnchangedIsAccepted) {
  const test::AlignedBytes bytes(parts_->bytes());
  const auto loaded = verify(bytes.bytes());
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_GE(node_count(), 20u);
}

TEST_F(CraftedBvh, Cycle) {
  child(find(false, 3)) = ChildRef::node(0);
  expect_refused("node that comes later");
}

TEST_F(CraftedBvh, NodeThatIsItsOwnChild) {
  const Place place = find(false, 3);
  child(place) = ChildRef::node(place.node);
  expect_refused("node that comes later");
}

TEST_F(CraftedBvh, SharedChild) {
  // The same node below two parents, the second of which could contain it.
  const ChildRef first = child(find(false, 0));
  WideNode& root = node(0);
  for (int axis = 0; axis < 3; ++axis) {
    root.lo[axis][1] = -1e6f;
    root.hi[axis][1] = 1e6f;
  }
  root.children[1] = first;
  expect_refused("depth-first order");
}

TEST_F(CraftedBvh, Orphan) {
  auto& nodes = parts_->section(SectionType::bvh_nodes);
  const WideNode last = node(node_count() - 1);
  nodes.bytes.resize(nodes.bytes.size() + sizeof(WideNode));
  nodes.entry.count += 1;
  nodes.entry.size += sizeof(WideNode);
  node(nodes.entry.count - 1) = last;
  expect_refused("not part of the tree");
}

TEST_F(CraftedBvh, ChildBeyondTheLastNode) {
  for (const std::size_t index : {node_count(), std::size_t{0x7fffffff}}) {
    child(find(false, 2)) = ChildRef::node(index);
    expect_refused("node that comes later");
  }
}

TEST_F(CraftedBvh, ChildrenSwapped) {
  // The two subtrees of the root change places: a tree still, but not in order.
  WideNode& root = node(0);
  std::swap(root.children[0], root.children[1]);
  for (int axis = 0; axis < 3; ++axis) {
    std::swap(root.lo[axis][0], root.lo[axis][1]);
    std::swap(root.hi[axis][0], root.hi[axis][1]);
  }
  expect_refused("depth-first order");
}

TEST_F(CraftedBvh, NodeWithoutChildren) {
  WideNode& last = node(node_count() - 1);
  for (int slot = 0; slot < kWideWidth; ++slot) {
    last.children[slot] = ChildRef();
    for (int axis = 0; axis < 3; ++axis) {
      last.lo[axis][slot] = Bounds3f::kInfinity;
      last.hi[axis][slot] = -Bounds3f::kInfinity;
    }
  }
  expect_refused("no children");
}

TEST_F(CraftedBvh, EmptyChildWithABox) {
  node(1).hi[2][15] = 0;
  expect_refused("empty child");
}

TEST_F(CraftedBvh, EmptyChildBeforeOthers) {
  WideNode& root = node(0);
  root.children[0] = ChildRef();
  expect_refused("no children");
  root.children[5] = ChildRef::leaf(ShapeKind::sphere, 0);
  root.children[0] = ChildRef::node(1);
  expect_refused("empty child");
}

TEST_F(CraftedBvh, TooDeep) {
  // A chain of nodes above the tree: boxes, order and leaves are right, only the depth is not.
  auto& nodes = parts_->section(SectionType::bvh_nodes);
  std::vector<WideNode> chain(kMaxWideDepth);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    chain[i] = node(node_count() - 1);
    for (int slot = 0; slot < kWideWidth; ++slot) {
      chain[i].children[slot] = ChildRef();
      for (int axis = 0; axis < 3; ++axis) {
        chain[i].lo[axis][slot] = slot == 0 ? -1e6f : Bounds3f::kInfinity;
        chain[i].hi[axis][slot] = slot == 0 ? 1e6f : -Bounds3f::kInfinity;
      }
    }
    chain[i].children[0] = ChildRef::node(i + 1);
  }
  for (std::size_t i = 0; i < node_count(); ++i) {
    for (ChildRef& ref : node(i).children) {
      if (ref.is_node()) ref = ChildRef::node(ref.node_index() + chain.size());
    }
  }
  const auto* bytes = reinterpret_cast<const std::byte*>(chain.data());
  nodes.bytes.insert(nodes.bytes.begin(), bytes, bytes + chain.size() * sizeof(WideNode));
  nodes.entry.count += chain.size();
  nodes.entry.size += chain.size() * sizeof(WideNode);
  expect_refused("too deep");
}

TEST_F(CraftedBvh, HalfABvh) {
  const auto remove = [&](SectionType type) {
    parts_ = std::make_unique<test::FileParts>(file_);
    std::erase_if(parts_->sections,
                  [&](const auto& s) { return s.entry.type == static_cast<std::uint32_t>(type); });
    expect_file_refused("one is missing");
  };
  remove(SectionType::bvh_nodes);
  remove(SectionType::bvh_leaves);
}

TEST_F(CraftedBvh, IdOutOfRangeOrOfAnotherKind) {
  int n = 0;
  while (count_of(child(find(true, n)).leaf_ref()) != 1) ++n;
  const LeafRef leaf = child(find(true, n)).leaf_ref();
  const std::size_t spheres = scene_.spheres.size();
  const std::uint32_t other_kind =
      leaf.kind() == ShapeKind::sphere ? static_cast<std::uint32_t>(spheres) : 0u;
  for (const std::uint32_t id : {other_kind, std::uint32_t{1000}, kNoPrim - 1}) {
    row(leaf.first_row() + leaf_id_row(leaf.kind())).words[0] = id;
    expect_refused("not one of its kind");
  }
}

TEST_F(CraftedBvh, DuplicatedId) {
  // The first leaf of spheres becomes a copy of the second, which is as long; boxes that are
  // around everything make it a tree, but not of this scene.
  std::vector<LeafRef> leaves;
  for (int n = 0; leaves.size() < 2; ++n) {
    const LeafRef leaf = child(find(true, n)).leaf_ref();
    if (leaf.kind() != ShapeKind::sphere) continue;
    if (leaves.empty() || count_of(leaf) == count_of(leaves[0])) leaves.push_back(leaf);
  }
  for (std::size_t r = 0; r < leaf_rows(ShapeKind::sphere); ++r) {
    row(leaves[0].first_row() + r) = row(leaves[1].first_row() + r);
  }
  for (std::size_t i = 0; i < node_count(); ++i) {
    for (int slot = 0; slot < kWideWidth && !node(i).children[slot].empty(); ++slot) {
      for (int axis = 0; axis < 3; ++axis) {
        node(i).lo[axis][slot] = -1e6f;
        node(i).hi[axis][slot] = 1e6f;
      }
    }
  }
  const test::AlignedBytes bytes(parts_->bytes());
  const auto loaded = verify(bytes.bytes());
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().message.find("missing and another there twice"), std::string::npos)
      << loaded.error().message;
  EXPECT_TRUE(verify(bytes.bytes(), {true, VerifyScope::bvh_only}));  // whole, and safe to traverse
}

TEST_F(CraftedBvh, PrimitivesLeftOut) {
  // A whole tree, but of another scene with one sphere fewer.
  Scene smaller = scene_;
  smaller.spheres.pop_back();
  smaller.sphere_materials.pop_back();
  smaller.runs[0].count -= 1;
  test::FileParts other(test::scene_bytes_with_bvh(smaller, 3, 2));
  for (const SectionType type : {SectionType::bvh_nodes, SectionType::bvh_leaves}) {
    parts_->section(type) = other.section(type);
  }
  expect_refused("number of primitives");
}

TEST_F(CraftedBvh, CoordinateThatIsNone) {
  for (const float value : {kNan, Bounds3f::kInfinity, -2e18f}) {
    std::uint32_t& number = row(0).words[0];
    const std::uint32_t before = number;
    number = std::bit_cast<std::uint32_t>(value);
    expect_refused("coordinate in a leaf");
    number = before;
  }
}

TEST_F(CraftedBvh, LeafBoxThatDoesNotContainItsPrimitives) {
  for (const bool upper : {false, true}) {
    for (int axis = 0; axis < 3; ++axis) {
      parts_ = std::make_unique<test::FileParts>(file_);
      const Place place = find(true, 7);
      float& bound =
          upper ? node(place.node).hi[axis][place.slot] : node(place.node).lo[axis][place.slot];
      bound = std::nextafter(bound, upper ? -1e30f : 1e30f);
      expect_refused("leaf's box");
    }
  }
}

TEST_F(CraftedBvh, NodeBoxThatDoesNotContainItsChildren) {
  for (const bool upper : {false, true}) {
    for (int axis = 0; axis < 3; ++axis) {
      parts_ = std::make_unique<test::FileParts>(file_);
      const Place place = find(false, 2);
      float& bound =
          upper ? node(place.node).hi[axis][place.slot] : node(place.node).lo[axis][place.slot];
      bound = std::nextafter(bound, upper ? -1e30f : 1e30f);
      expect_refused("does not contain the boxes in it");
    }
  }
}

TEST_F(CraftedBvh, BoxThatIsNotFinite) {
  for (const float value : {kNan, Bounds3f::kInfinity}) {
    node(2).hi[1][0] = value;
    expect_refused("not finite");
  }
}

// This takes reading the shapes: found when everything is verified, and harmless when not.
TEST_F(CraftedBvh, PrimitiveThatIsNotTheShapeOfItsId) {
  auto& radius = parts_->element<Sphere>(SectionType::spheres, 5).radius;
  radius *= 1.5;
  const test::AlignedBytes bytes(parts_->bytes());
  const auto loaded = verify(bytes.bytes());
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().message.find("not the shape of that id"), std::string::npos);
  const auto for_rendering = verify(bytes.bytes(), {true, VerifyScope::bvh_only});
  ASSERT_TRUE(for_rendering);
  EXPECT_FALSE(for_rendering->shapes_verified);
}

// Every reference and every box bound, each with every bit flipped, without checksums to
// help: refused or harmless, whichever check it is that notices.
TEST_F(CraftedBvh, FlippedBitsOfNodesNeverPassUnlessHarmless) {
  const std::size_t bits = 8 * sizeof(WideNode) * node_count();
  const auto* original =
      reinterpret_cast<const WideNode*>(parts_->section(SectionType::bvh_nodes).bytes.data());
  SceneView view = scene_;
  std::vector<WideNode> nodes(original, original + node_count());
  const test::AlignedBytes rows(parts_->section(SectionType::bvh_leaves).bytes);
  view.bvh.rows = {reinterpret_cast<const LeafRow*>(rows.bytes().data()), row_count()};
  view.bvh.nodes = nodes;
  auto* raw = reinterpret_cast<unsigned char*>(nodes.data());
  std::size_t accepted = 0;
  for (std::size_t bit = 0; bit < bits; bit += 3) {
    const std::size_t in_node = bit / 8 % sizeof(WideNode);
    raw[bit / 8] ^= static_cast<unsigned char>(1u << bit % 8);
    const bool passed = BvhVerifier(view.bvh, view).check_everything().ok();
    accepted += passed;
    // All that may pass is a box that has become larger.
    if (passed) {
      ASSERT_LT(in_node, offsetof(WideNode, children)) << "bit " << bit;
    }
    raw[bit / 8] ^= static_cast<unsigned char>(1u << bit % 8);
  }
  EXPECT_LT(accepted, bits / 3 / 5);
}

}  // namespace
}  // namespace dapple
