#include "textbook/world.h"

#include "textbook/shapes.h"

namespace dapple::textbook {

World::World(const SceneView& scene) {
  objects_.reserve(scene.object_count());
  for_each_object(scene, [&](ShapeKind kind, std::size_t i) {
    const Material& material = scene.materials[index_of(scene.materials_of(kind)[i])];
    if (kind == ShapeKind::sphere) {
      objects_.push_back(std::make_unique<SphereObject>(scene.spheres[i], material));
    } else {
      const Rectangle& rectangle = scene.rectangles[rectangle_index(kind)][i];
      objects_.push_back(std::make_unique<RectangleObject>(kind, rectangle, material));
    }
  });
}

void World::build_tree() {
  root_.reset();
  if (objects_.size() < 2) return;
  std::vector<const Hittable*> order;
  order.reserve(objects_.size());
  for (const auto& object : objects_) order.push_back(object.get());
  root_ = std::make_unique<BvhNode>(order, 0);
}

}  // namespace dapple::textbook
