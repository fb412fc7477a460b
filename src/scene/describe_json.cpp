#include <array>

#include "scene/describe.h"
#include "scene/describe_json_looks.h"
#include "scene/footprint.h"
#include "scene/json_text.h"
#include "scene/mesh_summary.h"

namespace dapple {
namespace {

void print_counts(const SceneView& scene, TextWriter& out) {
  out.print("\"counts\":{{\"objects\":{}", scene.object_count());
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    out.print(",\"{}\":{}", shape_name(kind), scene.count(kind));
  }
  out.print(",\"materials\":{},\"bvh_nodes\":{},\"vertices\":{}", scene.materials.size(),
            scene.bvh.nodes.size(), scene.vertices.positions.size());
  const Footprint footprint = footprint_of(scene);
  out.print(",\"bytes\":{},\"bytes_per_triangle\":{},\"bytes_per_instance\":{}}},\n",
            footprint.total, json_number(footprint.per_triangle),
            json_number(footprint.per_instance));
}

void print_rectangle(ShapeKind kind, const Rectangle& r, TextWriter& out) {
  const char u = shape_name(kind)[0], v = shape_name(kind)[1];
  out.print("\"{0}0\":{1},\"{0}1\":{2}", u, json_number(r.u0), json_number(r.u1));
  out.print(",\"{0}0\":{1},\"{0}1\":{2}", v, json_number(r.v0), json_number(r.v1));
  out.print(",\"k\":{}", json_number(r.k));
}

void print_cylinder(const Cylinder& cylinder, TextWriter& out) {
  print_json_vector("begin", cylinder.begin, out);
  out.print(",");
  print_json_vector("end", cylinder.end, out);
  out.print(",\"radius\":{}", json_number(cylinder.radius));
}

void print_instance(const Instance& instance, TextWriter& out) {
  out.print("\"prototype\":{},\"to_world\":[", instance.prototype);
  const char* separator = "";
  for (const auto& row : instance.to_world.rows) {
    out.print("{}[{},{},{},{}]", separator, json_number(row[0]), json_number(row[1]),
              json_number(row[2]), json_number(row[3]));
    separator = ",";
  }
  out.print("]");
}

// Each object in turn, a line each; triangles that follow each other are one mesh.
class ObjectPrinter {
 public:
  ObjectPrinter(const SceneView& scene, TextWriter& out)
      : scene_(scene), out_(out), meshes_(scene) {}

  void print_all() {
    out_.print("\"objects\":[");
    separator_ = "\n";
    for (const ObjectRun& run : scene_.runs) {
      std::size_t& next = next_[static_cast<std::size_t>(run.kind)];
      if (run.kind == ShapeKind::triangle) {
        if (run.count > 0) print_mesh("\"type\":\"mesh\",", next, run.count);
      } else {
        for (std::size_t i = next; i < next + run.count && out_.good(); ++i) print(run.kind, i);
      }
      next += run.count;
    }
    out_.print("],\n");
  }

  void print_prototypes() {
    out_.print("\"prototypes\":[");
    separator_ = "\n";
    for (const Prototype& p : scene_.prototypes) {
      print_mesh("", p.first_triangle, p.triangle_count);
    }
    out_.print("]");
  }

 private:
  void print(ShapeKind kind, std::size_t index) {
    out_.print("{}{{\"type\":\"{}\",", separator_, shape_name(kind));
    separator_ = ",\n";
    if (kind == ShapeKind::sphere) {
      print_json_vector("centre", scene_.spheres[index].centre, out_);
      out_.print(",\"radius\":{}", json_number(scene_.spheres[index].radius));
    } else if (kind == ShapeKind::cylinder) {
      print_cylinder(scene_.cylinders[index], out_);
    } else if (kind == ShapeKind::instance) {
      print_instance(scene_.instances[index], out_);
    } else {
      print_rectangle(kind, scene_.rectangles[rectangle_index(kind)][index], out_);
    }
    if (kind != ShapeKind::instance) {
      out_.print(",\"material\":{}", index_of(scene_.materials_of(kind)[index]));
    }
    out_.print("}}");
  }

  void print_mesh(const char* type, std::size_t first, std::size_t count) {
    if (!out_.good()) return;
    const MeshSummary mesh = meshes_.summarize(first, count);
    out_.print("{}{{{}\"first_triangle\":{},\"triangles\":{},", separator_, type, first, count);
    separator_ = ",\n";
    print_json_vector("lo", mesh.box.lo, out_);
    out_.print(",");
    print_json_vector("hi", mesh.box.hi, out_);
    out_.print(",\"materials\":[");
    const char* comma = "";
    for (const MaterialId material : mesh.materials) {
      out_.print("{}{}", comma, index_of(material));
      comma = ",";
    }
    out_.print("]}}");
  }

  const SceneView& scene_;
  TextWriter& out_;
  MeshSummarizer meshes_;
  const char* separator_ = "";
  std::array<std::size_t, kShapeKindCount> next_{};
};

}  // namespace

Status describe_json(const SceneView& scene, const TextSink& sink) {
  TextWriter out(sink);
  out.print("{{\n\"camera\":");
  print_json_camera(scene.camera, out);
  out.print(",\n");
  print_counts(scene, out);
  print_json_looks(scene, out);
  ObjectPrinter objects(scene, out);
  objects.print_all();
  objects.print_prototypes();
  out.print("\n}}\n");
  return out.finish();
}

}  // namespace dapple
