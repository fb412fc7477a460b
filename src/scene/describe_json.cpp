#include <string>
#include <variant>

#include "scene/describe.h"

namespace dapple {
namespace {

// A finite number as the shortest text that reads back as the same double. One without a decimal
// point or an exponent gets a point: a reader may take -0 for an integer and lose its sign.
std::string number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

void print_vector(const char* name, const Vec3d& v, TextWriter& out) {
  out.print("\"{}\":[{},{},{}]", name, number(v.x), number(v.y), number(v.z));
}

void print_camera(const Camera& camera, TextWriter& out) {
  out.print("\"camera\":{{");
  print_vector("lookfrom", camera.look_from, out);
  out.print(",");
  print_vector("lookat", camera.look_at, out);
  out.print(",");
  print_vector("up", camera.up, out);
  out.print(",\"vertical_fov\":{},\"aperture\":{},\"focus_distance\":{}}},\n",
            number(camera.vertical_fov), number(camera.aperture), number(camera.focus_distance));
}

void print_counts(const SceneView& scene, TextWriter& out) {
  out.print("\"counts\":{{\"objects\":{}", scene.object_count());
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    out.print(",\"{}\":{}", shape_name(kind), scene.count(kind));
  }
  out.print(",\"materials\":{},\"bvh_nodes\":{}}},\n", scene.materials.size(),
            scene.bvh.nodes.size());
}

struct PrintMaterial {
  TextWriter& out;

  void operator()(const Lambertian& m) const {
    out.print("{{\"type\":\"lambertian\",");
    print_vector("albedo", m.albedo, out);
    out.print("}}");
  }
  void operator()(const Metal& m) const {
    out.print("{{\"type\":\"metal\",");
    print_vector("albedo", m.albedo, out);
    out.print(",\"fuzz\":{}}}", number(m.fuzz));
  }
  void operator()(const Dielectric& m) const {
    out.print("{{\"type\":\"dielectric\",\"ref_idx\":{}}}", number(m.ref_idx));
  }
  void operator()(const Layered& m) const {
    out.print("{{\"type\":\"layered\",\"index\":{}}}", m.index);
  }
};

void print_materials(const SceneView& scene, TextWriter& out) {
  out.print("\"materials\":[");
  const char* separator = "\n";
  for (const Material& material : scene.materials) {
    if (!out.good()) return;
    out.print("{}", separator);
    std::visit(PrintMaterial{out}, material);
    separator = ",\n";
  }
  out.print("],\n");
}

void print_sphere(const Sphere& sphere, TextWriter& out) {
  print_vector("centre", sphere.centre, out);
  out.print(",\"radius\":{}", number(sphere.radius));
}

void print_rectangle(ShapeKind kind, const Rectangle& r, TextWriter& out) {
  const char u = shape_name(kind)[0], v = shape_name(kind)[1];
  out.print("\"{0}0\":{1},\"{0}1\":{2}", u, number(r.u0), number(r.u1));
  out.print(",\"{0}0\":{1},\"{0}1\":{2}", v, number(r.v0), number(r.v1));
  out.print(",\"k\":{}", number(r.k));
}

void print_objects(const SceneView& scene, TextWriter& out) {
  out.print("\"objects\":[");
  const char* separator = "\n";
  for_each_object(scene, [&](ShapeKind kind, std::size_t index) {
    if (!out.good()) return;
    out.print("{}{{\"type\":\"{}\",", separator, shape_name(kind));
    if (kind == ShapeKind::sphere) {
      print_sphere(scene.spheres[index], out);
    } else if (is_rectangle(kind)) {
      print_rectangle(kind, scene.rectangles[rectangle_index(kind)][index], out);
    }
    if (kind == ShapeKind::instance) {
      out.print("\"prototype\":{}}}", scene.instances[index].prototype);
    } else {
      out.print("{}\"material\":{}}}", kind > ShapeKind::yz_rectangle ? "" : ",",
                index_of(scene.materials_of(kind)[index]));
    }
    separator = ",\n";
  });
  out.print("]");
}

}  // namespace

Status describe_json(const SceneView& scene, const TextSink& sink) {
  TextWriter out(sink);
  out.print("{{\n");
  print_camera(scene.camera, out);
  print_counts(scene, out);
  print_materials(scene, out);
  print_objects(scene, out);
  out.print("\n}}\n");
  return out.finish();
}

}  // namespace dapple
