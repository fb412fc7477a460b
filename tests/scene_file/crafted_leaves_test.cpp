// Files with broken leaves of a BVH inside, checksums all right: each check on its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/scene_file/crafted_bvh.h"

namespace dapple {
namespace {

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

}  // namespace
}  // namespace dapple
