// The proof of a leaf gives the same verdict on every instruction set.
#include "scene_file/leaf_check.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>

#include "math/random.h"
#include "scene/prims.h"

namespace dapple {
namespace {

constexpr std::uint32_t kIdCount = 1000;

struct RandomLeaf {
  ShapeKind kind = ShapeKind::sphere;
  std::array<LeafRow, kMaxLeafRows> rows{};
  std::size_t count = 0;
};

// Inside the box [-2, 2]^3, ids ascending from below kIdCount.
RandomLeaf random_leaf(std::uint32_t seed) {
  RandomLeaf leaf;
  const auto pick = philox4x32({seed, 0, 0, 1}, 7);
  leaf.kind = static_cast<ShapeKind>(pick[0] % kShapeKindCount);
  leaf.count = 1 + pick[1] % kLeafWidth;
  clear_leaf(leaf.kind, leaf.rows.data());
  for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
    for (std::uint32_t row = 0; row < leaf_id_row(leaf.kind); ++row) {
      const float number = uniform4(seed, lane, row, 2, 7)[0];
      leaf.rows[row].words[lane] = std::bit_cast<std::uint32_t>(number);
    }
    leaf.rows[leaf_id_row(leaf.kind)].words[lane] = 60 * lane + pick[2] % 60;
  }
  return leaf;
}

TEST(LeafCheck, AcceptsGoodLeavesOnEveryInstructionSet) {
  const Bounds3f box{{-2, -2, -2}, {2, 2, 2}};
  ASSERT_FALSE(leaf_checks().empty());
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    const RandomLeaf leaf = random_leaf(seed);
    for (const LeafCheck check : leaf_checks()) {
      const LeafVerdict verdict = check(leaf.kind, leaf.rows.data(), box, {0, kIdCount});
      EXPECT_EQ(verdict.fault, LeafFault::none) << "seed " << seed;
      EXPECT_EQ(verdict.count, leaf.count) << "seed " << seed;
    }
  }
}

// One number of one lane at a time takes values of all kinds. What is accepted may depend on the
// value; it must not depend on the width of vectors.
TEST(LeafCheck, AgreesOnBadLeaves) {
  const Bounds3f box{{-2, -2, -2}, {2, 2, 2}};
  const std::uint32_t values[] = {0u,          1u,          0x80000000u, 0x3f800000u,
                                  0x7f800000u, 0xff800000u, 0x7fc00000u, 0x5e000000u,
                                  0xdf800000u, 0xffffffffu, 999u,        1000u};
  std::size_t refused = 0, accepted = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    RandomLeaf leaf = random_leaf(seed);
    for (std::size_t row = 0; row < leaf_rows(leaf.kind); ++row) {
      for (std::size_t lane = 0; lane < kLeafWidth; ++lane) {
        std::uint32_t& word = leaf.rows[row].words[lane];
        const std::uint32_t before = word;
        for (const std::uint32_t value : values) {
          word = value;
          const auto expected =
              leaf_checks().front()(leaf.kind, leaf.rows.data(), box, {0, kIdCount});
          (expected.fault == LeafFault::none ? accepted : refused) += 1;
          for (const LeafCheck check : leaf_checks()) {
            const auto verdict = check(leaf.kind, leaf.rows.data(), box, {0, kIdCount});
            ASSERT_EQ(verdict.fault == LeafFault::none, expected.fault == LeafFault::none)
                << "seed " << seed << " row " << row << " lane " << lane << " value " << value;
          }
        }
        word = before;
      }
    }
  }
  EXPECT_GT(refused, 1000u);
  EXPECT_GT(accepted, 1000u);
}

}  // namespace
}  // namespace dapple
