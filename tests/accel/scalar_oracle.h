// The definition of a hit (accel/intersect_scalar.h), applied to every object in turn, without
// any structure or SIMD: what every way of finding hits must return bit for bit.
#pragma once

#include <span>
#include <vector>

#include "accel/hit.h"
#include "accel/intersect_scalar.h"
#include "accel/placed_instance.h"
#include "scene/prims.h"

namespace dapple::test {

class ScalarOracle {
 public:
  explicit ScalarOracle(const SceneView& scene)
      : boxes_(prototype_boxes(scene)), prototypes_(scene.prototypes) {
    const auto first_ids = first_prim_ids(scene);
    first_triangle_ = first_ids[static_cast<std::size_t>(ShapeKind::triangle)];
    for (std::size_t k = 0; k < kShapeKindCount; ++k) {
      const auto kind = static_cast<ShapeKind>(k);
      for (std::size_t i = 0; i < scene.count(kind); ++i) {
        Prim prim{kind, static_cast<PrimId>(first_ids[k] + i), {}};
        // One leaf for each, of which one lane is used.
        prim.rows.resize(leaf_rows(kind));
        clear_leaf(kind, prim.rows.data());
        write_lane(scene, boxes_, kind, i, prim.id, prim.rows.data(), 0);
        (i < scene.object_count(kind) ? world_ : hidden_).push_back(prim);
      }
    }
    const std::vector<std::uint32_t> contents(scene.prototypes.size());
    instances_ = place_instances(scene, contents);
    for (const Instance& instance : scene.instances) prototype_of_.push_back(instance.prototype);
    first_instance_ = first_ids[static_cast<std::size_t>(ShapeKind::instance)];
    hidden_begin_ = first_triangle_ + scene.object_count(ShapeKind::triangle);
  }

  // All but the hit's lane, which only a structure has: of it the instance is told.
  Hit intersect(const Ray& input) const {
    const PreparedRay ray = prepare(input);
    Hit best{ray.t_max, kNoPrim, {}};
    for (const Prim& prim : world_) {
      if (prim.kind == ShapeKind::instance) {
        look_inside(ray, prim, best);
      } else {
        test(ray, prim, best);
      }
    }
    return best.found() ? best : Hit{};
  }

 private:
  struct Prim {
    ShapeKind kind;
    PrimId id;
    std::vector<LeafRow> rows;
  };

  // In ascending order of ids an equal distance never replaces the first.
  static void test(const PreparedRay& ray, const Prim& prim, Hit& best) {
    const float t = intersect_lane(ray, prim.rows.data(), LeafRef(prim.kind, 0), best.t);
    if (t >= 0 && (t < best.t || !best.found())) best = {t, prim.id, {}};
  }

  void look_inside(const PreparedRay& ray, const Prim& prim, Hit& best) const {
    const std::size_t index = prim.id - first_instance_;
    float box[6];
    for (std::size_t i = 0; i < 6; ++i) {
      box[i] = leaf_float(prim.rows.data(), LeafRef(prim.kind, 0), i);
    }
    const Slab passed = padded_interval(ray, box, box + 3);
    if (!(passed.near <= passed.far && passed.near <= ray.t_max)) return;
    if (instances_[index].content == PlacedInstance::kNothing) return;
    const PreparedRay within = enter_instance(instances_[index], ray);
    const Prototype& prototype = prototypes_[prototype_of_[index]];
    Hit inside{within.t_max, kNoPrim, {}};
    for (std::size_t i = 0; i < prototype.triangle_count; ++i) {
      test(within, hidden_[first_triangle_ + prototype.first_triangle + i - hidden_begin_], inside);
    }
    if (!inside.found()) return;
    inside.t = larger(inside.t, passed.near);
    inside.lane = inside.lane.through(index);
    if (inside.t < best.t || !best.found()) best = inside;
  }

  PrototypeBoxes boxes_;
  std::span<const Prototype> prototypes_;
  std::vector<Prim> world_, hidden_;  // what stands in the world, triangles of prototypes
  std::vector<PlacedInstance> instances_;
  std::vector<std::uint32_t> prototype_of_;
  std::size_t first_triangle_ = 0, first_instance_ = 0, hidden_begin_ = 0;
};

}  // namespace dapple::test
