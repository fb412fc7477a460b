// Files with a broken BVH inside, checksums all right: each check on its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "scene/named_scenes.h"
#include "scene/prims.h"
#include "scene_file/verify.h"
#include "scene_file/verify_bvh.h"
#include "tests/scene_file/scene_bytes.h"
#include "tests/scene_file/small_bvh.h"

namespace dapple {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Of a mixture of spheres and rectangles, several levels deep.
class CraftedBvh : public testing::Test {
 protected:
  CraftedBvh() {
    scene_ = *make_named_scene("rgbbox:4");
    for (int i = 0; i < 12; ++i) {
      const double x = i;
      scene_.add_rectangle(rectangle_kind(static_cast<std::size_t>(i) % 3),
                           {x, x + 1, -x, 2 * x, -x}, MaterialId{0});
    }
    file_ = test::scene_bytes_with_bvh(scene_, 3, 2);
    parts_ = std::make_unique<test::FileParts>(file_);
  }

  WideNode& node(std::size_t i) { return parts_->element<WideNode>(SectionType::bvh_nodes, i); }
  LeafRow& row(std::size_t i) { return parts_->element<LeafRow>(SectionType::bvh_leaves, i); }
  std::size_t count_of(LeafRef leaf) {
    const LeafRow& ids = row(leaf.first_row() + leaf_id_row(leaf.kind()));
    return static_cast<std::size_t>(std::find(ids.words, ids.words + kLeafWidth, kNoPrim) -
                                    ids.words);
  }
  void resize_leaves(std::size_t rows) {
    auto& leaves = parts_->section(SectionType::bvh_leaves);
    leaves.bytes.resize(rows * sizeof(LeafRow));
    leaves.entry.count = rows;
    leaves.entry.size = leaves.bytes.size();
  }
  std::size_t row_count() { return parts_->section(SectionType::bvh_leaves).entry.count; }
  std::size_t node_count() { return parts_->section(SectionType::bvh_nodes).entry.count; }

  struct Place {
    std::size_t node;
    int slot;
  };
  // The n-th child of all that are leaves, or of all that are nodes.
  Place find(bool leaf, int n) {
    for (std::size_t i = 0; i < node_count(); ++i) {
      for (int slot = 0; slot < kWideWidth && !node(i).children[slot].empty(); ++slot) {
        if (node(i).children[slot].is_leaf() == leaf && n-- == 0) return {i, slot};
      }
    }
    ADD_FAILURE() << "no such child";
    return {0, 0};
  }
  ChildRef& child(Place place) { return node(place.node).children[place.slot]; }

  // Everything that the checks say, each node and each check on its own.
  std::vector<std::string> all_reasons() {
    SceneView view = scene_;
    const auto& nodes = parts_->section(SectionType::bvh_nodes);
    const auto& rows = parts_->section(SectionType::bvh_leaves);
    const test::AlignedBytes node_bytes(nodes.bytes);
    const test::AlignedBytes row_bytes(rows.bytes);
    view.bvh.nodes = {reinterpret_cast<const WideNode*>(node_bytes.bytes().data()),
                      nodes.entry.count};
    view.bvh.rows = {reinterpret_cast<const LeafRow*>(row_bytes.bytes().data()), rows.entry.count};
    BvhVerifier verifier(view.bvh, view);
    std::vector<std::string> reasons;
    const auto add = [&](const BvhDamage& damage) {
      if (!damage.ok()) reasons.emplace_back(damage.reason);
    };
    add(verifier.check_order());
    for (std::size_t i = 0; i < nodes.entry.count; ++i) add(verifier.check_nodes(i, i + 1));
    add(verifier.check_count());
    return reasons;
  }

  // One of the checks finds this reason, and reading the file fails.
  void expect_refused(const std::string& reason) {
    const auto reasons = all_reasons();
    EXPECT_TRUE(std::any_of(
        reasons.begin(), reasons.end(),
        [&](const std::string& found) { return found.find(reason) != std::string::npos; }))
        << "not among " << testing::PrintToString(reasons) << ": " << reason;
    expect_file_refused("BVH node");
  }

  void expect_file_refused(const std::string& message) {
    const test::AlignedBytes bytes(parts_->bytes());
    for (const VerifyScope scope : {VerifyScope::everything, VerifyScope::bvh_only}) {
      const auto loaded = verify(bytes.bytes(), {true, scope});
      ASSERT_FALSE(loaded) << message;
      EXPECT_EQ(loaded.error().code, Errc::bad_data);
      EXPECT_NE(loaded.error().message.find(message), std::string::npos) << loaded.error().message;
    }
  }

  Scene scene_;
  std::vector<std::byte> file_;
  std::unique_ptr<test::FileParts> parts_;
};

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

TEST_F(CraftedBvh, LeafOfUnknownKind) {
  const Place place = find(true, 4);
  const std::size_t first_row = child(place).leaf_row();
  child(place) = ChildRef::leaf(static_cast<ShapeKind>(kShapeKindCount), first_row);
  expect_refused("no known kind");
}

TEST_F(CraftedBvh, LeafOfAnotherKind) {
  const Place place = find(true, 4);
  const ChildRef before = child(place);
  const auto other =
      before.leaf_kind() == ShapeKind::sphere ? ShapeKind::xy_rectangle : ShapeKind::sphere;
  child(place) = ChildRef::leaf(other, before.leaf_row());
  expect_file_refused("BVH node");
}

TEST_F(CraftedBvh, LeafWithoutPrimitives) {
  const LeafRef leaf = child(find(true, 4)).leaf_ref();
  clear_leaf(leaf.kind(), &row(leaf.first_row()));
  expect_refused("no primitives");
}

TEST_F(CraftedBvh, LanesOutOfOrder) {
  for (int n = 0;; ++n) {
    const LeafRef leaf = child(find(true, n)).leaf_ref();
    if (count_of(leaf) < 2) continue;
    for (std::size_t r = 0; r < leaf_rows(leaf.kind()); ++r) {
      std::swap(row(leaf.first_row() + r).words[0], row(leaf.first_row() + r).words[1]);
    }
    break;
  }
  expect_refused("not first or not in order");
}

TEST_F(CraftedBvh, EmptyLaneBeforeOthers) {
  const LeafRef leaf = child(find(true, 0)).leaf_ref();
  for (std::size_t r = 0; r < leaf_rows(leaf.kind()); ++r) {
    LeafRow& at = row(leaf.first_row() + r);
    std::swap(at.words[0], at.words[kLeafWidth - 1]);
  }
  expect_refused("not first or not in order");
}

TEST_F(CraftedBvh, UnusedLaneThatIsNotEmpty) {
  for (int n = 0; n < 60; ++n) {
    parts_ = std::make_unique<test::FileParts>(file_);
    const LeafRef leaf = child(find(true, n)).leaf_ref();
    const std::size_t r = static_cast<std::size_t>(n) % leaf_id_row(leaf.kind());
    row(leaf.first_row() + r).words[5 + n % 11] ^= 0x80000000u;
    expect_refused("not in use is not empty");
  }
}

TEST_F(CraftedBvh, LeafBeyondTheLastRow) {
  const Place place = find(true, 4);
  const ShapeKind kind = child(place).leaf_kind();
  for (const std::size_t first_row : {row_count() - 1, row_count(), std::size_t{0xfffffff}}) {
    child(place) = ChildRef::leaf(kind, first_row);
    expect_refused("beyond the last row");
  }
}

TEST_F(CraftedBvh, LeafThatIsUsedTwice) {
  child(find(true, 4)) = child(find(true, 3));
  expect_refused("does not begin where the one before it ends");
}

TEST_F(CraftedBvh, RowsOfNoLeaf) {
  resize_leaves(row_count() + 5);
  expect_refused("belong to no leaf");
}

TEST_F(CraftedBvh, FewerRowsThanLeaves) {
  resize_leaves(1);
  expect_refused("beyond the last row");
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
