// A file with a BVH inside that tests break on purpose, its checksums mended afterwards.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "scene/named_scenes.h"
#include "scene/prims.h"
#include "scene_file/verify.h"
#include "scene_file/verify_bvh.h"
#include "tests/scene_file/scene_bytes.h"
#include "tests/scene_file/small_bvh.h"

namespace dapple {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

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

}  // namespace dapple
