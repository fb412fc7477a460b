#include "scene/describe.h"

#include <array>

#include "scene/describe_looks.h"
#include "scene/footprint.h"
#include "scene/mesh_summary.h"

namespace dapple {
namespace {

void print_vector(const char* name, const Vec3d& v, TextWriter& out) {
  out.print("    {}=({:f},{:f},{:f})\n", name, v.x, v.y, v.z);
}

void print_count(std::string_view name, std::size_t count, TextWriter& out) {
  if (count > 0) out.print("    {}={}\n", name, count);
}

// Scenes of spheres and rectangles are described as they always were.
void print_counts(const SceneView& scene, TextWriter& out) {
  out.print("counts\n    objects={}\n", scene.object_count());
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    if (k <= kRectangleKindCount || scene.count(kind) > 0) {
      out.print("    {}={}\n", shape_name(kind), scene.count(kind));
    }
  }
  out.print("    materials={}\n    bvh_nodes={}\n", scene.materials.size(), scene.bvh.nodes.size());
  print_count("vertices", scene.vertices.positions.size(), out);
  print_count("prototypes", scene.prototypes.size(), out);
  print_count("layered_materials", scene.layered_materials.size(), out);
  print_count("textures", scene.textures.size(), out);
  print_count("images", scene.images.size(), out);
  print_count("lights", scene.lights.size(), out);
  print_count("cameras", scene.cameras.size(), out);
  const Footprint footprint = footprint_of(scene);
  if (!scene.triangles.empty()) {
    out.print("    bytes_per_triangle={:.1f}\n", footprint.per_triangle);
  }
  if (!scene.instances.empty()) {
    out.print("    bytes_per_instance={:.1f}\n", footprint.per_instance);
  }
}

void print_rectangle(ShapeKind kind, const Rectangle& r, TextWriter& out) {
  const char u = shape_name(kind)[0], v = shape_name(kind)[1];
  out.print("    {0}0={1:f}\n    {0}1={2:f}\n", u, r.u0, r.u1);
  out.print("    {0}0={1:f}\n    {0}1={2:f}\n", v, r.v0, r.v1);
  out.print("    k={:f}\n", r.k);
}

void print_instance(const SceneView& scene, const Instance& instance, TextWriter& out) {
  out.print("instance\n    prototype={}\n    triangles={}\n", instance.prototype,
            scene.prototypes[instance.prototype].triangle_count);
  const char* separator = "    to_world=(";
  for (const auto& row : instance.to_world.rows) {
    out.print("{}({:f},{:f},{:f},{:f})", separator, row[0], row[1], row[2], row[3]);
    separator = ",";
  }
  out.print(")\n");
}

// Each object in turn; triangles that follow each other are one mesh.
class ObjectPrinter {
 public:
  ObjectPrinter(const SceneView& scene, DescribeDetail detail, TextWriter& out)
      : scene_(scene), detail_(detail), out_(out), meshes_(scene) {}

  void print_all() {
    for (const ObjectRun& run : scene_.runs) {
      std::size_t& next = next_[static_cast<std::size_t>(run.kind)];
      if (run.kind == ShapeKind::triangle) {
        print_mesh("mesh", next, run.count);
      } else {
        for (std::size_t i = next; i < next + run.count && out_.good(); ++i) print(run.kind, i);
      }
      next += run.count;
    }
  }

  void print_prototypes() {
    for (std::size_t i = 0; i < scene_.prototypes.size() && out_.good(); ++i) {
      print_mesh(fmt::format("prototype {}", i), scene_.prototypes[i].first_triangle,
                 scene_.prototypes[i].triangle_count);
    }
  }

 private:
  void print(ShapeKind kind, std::size_t index) {
    if (kind == ShapeKind::instance) return print_instance(scene_, scene_.instances[index], out_);
    out_.print("{}\n", shape_name(kind));
    if (kind == ShapeKind::sphere) {
      print_vector("centre", scene_.spheres[index].centre, out_);
      if (detail_ == DescribeDetail::full) {
        out_.print("    radius={:f}\n", scene_.spheres[index].radius);
      }
    } else if (kind == ShapeKind::cylinder) {
      print_vector("begin", scene_.cylinders[index].begin, out_);
      print_vector("end", scene_.cylinders[index].end, out_);
      out_.print("    radius={:f}\n", scene_.cylinders[index].radius);
    } else {
      print_rectangle(kind, scene_.rectangles[rectangle_index(kind)][index], out_);
    }
    print_material(scene_, scene_.materials_of(kind)[index], out_);
  }

  void print_mesh(std::string_view heading, std::size_t first, std::size_t count) {
    if (count == 0 || !out_.good()) return;
    const MeshSummary mesh = meshes_.summarize(first, count);
    out_.print("{}\n    triangles={}\n", heading, mesh.triangle_count);
    print_vector("lo", Vec3d(mesh.box.lo), out_);
    print_vector("hi", Vec3d(mesh.box.hi), out_);
    for (const MaterialId material : mesh.materials) {
      if (out_.good()) print_material(scene_, material, out_);
    }
  }

  const SceneView& scene_;
  DescribeDetail detail_;
  TextWriter& out_;
  MeshSummarizer meshes_;
  std::array<std::size_t, kShapeKindCount> next_{};
};

}  // namespace

Status describe(const SceneView& scene, DescribeDetail detail, const TextSink& sink) {
  TextWriter out(sink);
  if (detail == DescribeDetail::full) {
    out.print("camera\n");
    print_camera(scene.camera, out);
    print_counts(scene, out);
  }
  ObjectPrinter objects(scene, detail, out);
  objects.print_all();
  if (detail == DescribeDetail::full) {
    objects.print_prototypes();
    print_looks(scene, out);
  }
  return out.finish();
}

}  // namespace dapple
