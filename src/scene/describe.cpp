#include "scene/describe.h"

#include <variant>

namespace dapple {
namespace {

void print_vector(const char* name, const Vec3d& v, TextWriter& out) {
  out.print("    {}=({:f},{:f},{:f})\n", name, v.x, v.y, v.z);
}

void print_camera(const Camera& camera, TextWriter& out) {
  out.print("camera\n");
  print_vector("lookfrom", camera.look_from, out);
  print_vector("lookat", camera.look_at, out);
  print_vector("up", camera.up, out);
  out.print("    vertical_fov={:f}\n", camera.vertical_fov);
  out.print("    aperture={:f}\n", camera.aperture);
  out.print("    focus_distance={:f}\n", camera.focus_distance);
}

void print_counts(const SceneView& scene, TextWriter& out) {
  out.print("counts\n    objects={}\n", scene.object_count());
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    // Scenes of spheres and rectangles are described as they always were.
    if (k > kRectangleKindCount && scene.count(kind) == 0) continue;
    out.print("    {}={}\n", shape_name(kind), scene.count(kind));
  }
  out.print("    materials={}\n    bvh_nodes={}\n", scene.materials.size(), scene.bvh.nodes.size());
}

struct PrintMaterial {
  TextWriter& out;

  void operator()(const Lambertian& m) const {
    out.print("    material=lambertian(albedo=({:f},{:f},{:f}))\n", m.albedo.x, m.albedo.y,
              m.albedo.z);
  }
  void operator()(const Metal& m) const {
    out.print("    material=metal(albedo=({:f},{:f},{:f}), fuzz={:f})\n", m.albedo.x, m.albedo.y,
              m.albedo.z, m.fuzz);
  }
  void operator()(const Dielectric& m) const {
    out.print("    material=dielectric(ref_idx={:f})\n", m.ref_idx);
  }
  void operator()(const Layered& m) const { out.print("    material=layered({})\n", m.index); }
};

void print_sphere(const Sphere& sphere, DescribeDetail detail, TextWriter& out) {
  print_vector("centre", sphere.centre, out);
  if (detail == DescribeDetail::full) out.print("    radius={:f}\n", sphere.radius);
}

void print_rectangle(ShapeKind kind, const Rectangle& r, TextWriter& out) {
  const char u = shape_name(kind)[0], v = shape_name(kind)[1];
  out.print("    {0}0={1:f}\n    {0}1={2:f}\n", u, r.u0, r.u1);
  out.print("    {0}0={1:f}\n    {0}1={2:f}\n", v, r.v0, r.v1);
  out.print("    k={:f}\n", r.k);
}

}  // namespace

Status describe(const SceneView& scene, DescribeDetail detail, const TextSink& sink) {
  TextWriter out(sink);
  if (detail == DescribeDetail::full) {
    print_camera(scene.camera, out);
    print_counts(scene, out);
  }
  for_each_object(scene, [&](ShapeKind kind, std::size_t index) {
    if (!out.good()) return;
    out.print("{}\n", shape_name(kind));
    if (kind == ShapeKind::sphere) {
      print_sphere(scene.spheres[index], detail, out);
    } else if (is_rectangle(kind)) {
      print_rectangle(kind, scene.rectangles[rectangle_index(kind)][index], out);
    }
    if (kind == ShapeKind::instance) return;
    const MaterialId material = scene.materials_of(kind)[index];
    std::visit(PrintMaterial{out}, scene.materials[index_of(material)]);
  });
  return out.finish();
}

}  // namespace dapple
