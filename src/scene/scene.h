// A scene as plain arrays: what a file or a generator says, nothing derived from it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/layered_material.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "scene/texture.h"

namespace dapple {

// `count` objects of one kind that follow each other in the scene's stored order.
struct ObjectRun {
  ShapeKind kind = ShapeKind::sphere;
  std::uint64_t count = 0;
  friend bool operator==(const ObjectRun&, const ObjectRun&) = default;
};

// Each kind of shape has its own array, in stored order; `runs` says how the kinds interleave.
// materials[i] of a kind belongs to its shape i.
struct Scene {
  Camera camera;
  std::vector<Material> materials;
  std::vector<ObjectRun> runs;
  std::vector<Sphere> spheres;
  std::vector<MaterialId> sphere_materials;
  std::array<std::vector<Rectangle>, kRectangleKindCount> rectangles;
  std::array<std::vector<MaterialId>, kRectangleKindCount> rectangle_materials;

  Vertices vertices;
  std::vector<Triangle> triangles;
  std::vector<MaterialId> triangle_materials;
  std::vector<Cylinder> cylinders;
  std::vector<MaterialId> cylinder_materials;
  std::vector<Prototype> prototypes;
  std::vector<Instance> instances;

  std::vector<LayeredMaterial> layered_materials;
  std::vector<Texture> textures;
  std::vector<TextureImage> images;
  std::vector<std::uint8_t> texels;  // of all images
  std::vector<Light> lights;
  Environment environment;
  std::vector<NamedCamera> cameras;  // `camera` is the one in use

  MaterialId add_material(const Material& material);
  void add_sphere(const Sphere& sphere, MaterialId material);
  void add_rectangle(ShapeKind kind, const Rectangle& rectangle, MaterialId material);
  // A triangle of `vertices` that stands in the world; no more of them once there is a prototype.
  void add_triangle(const Triangle& triangle, MaterialId material);
  void add_cylinder(const Cylinder& cylinder, MaterialId material);
  // Returns its index. `ids` are the materials of the triangles.
  std::uint32_t add_prototype(std::span<const Triangle> of, std::span<const MaterialId> ids);
  void add_instance(const Instance& instance);

  friend bool operator==(const Scene&, const Scene&) = default;

 private:
  void count_object(ShapeKind kind);
};

}  // namespace dapple
