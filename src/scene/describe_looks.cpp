#include "scene/describe_looks.h"

#include <variant>

#include "scene/describe_names.h"
#include "scene/layered_fields.h"

namespace dapple {
namespace {

void print_vector(const char* name, const Vec3d& v, TextWriter& out) {
  out.print("    {}=({:f},{:f},{:f})\n", name, v.x, v.y, v.z);
}

void print_colour(std::string_view name, const Vec3f& c, TextWriter& out) {
  out.print("{}=({:f},{:f},{:f})", name, c.x, c.y, c.z);
}

bool is_always_said(std::string_view name) {
  return name == "base_colour" || name == "metallic" || name == "roughness";
}

struct PrintMaterial {
  const SceneView& scene;
  TextWriter& out;

  void operator()(const Lambertian& m) const {
    out.print("lambertian(albedo=({:f},{:f},{:f}))", m.albedo.x, m.albedo.y, m.albedo.z);
  }
  void operator()(const Metal& m) const {
    out.print("metal(albedo=({:f},{:f},{:f}), fuzz={:f})", m.albedo.x, m.albedo.y, m.albedo.z,
              m.fuzz);
  }
  void operator()(const Dielectric& m) const { out.print("dielectric(ref_idx={:f})", m.ref_idx); }
  void operator()(const Layered& m) const { print_layered(scene.layered_materials[m.index], out); }
};

void print_textures(const SceneView& scene, TextWriter& out) {
  for (std::size_t i = 0; i < scene.textures.size() && out.good(); ++i) {
    const Texture& t = scene.textures[i];
    out.print("texture {}\n    image={}\n    wrap=({},{})\n    filter={}\n", i,
              static_cast<std::uint32_t>(t.image), name_of(t.wrap_u), name_of(t.wrap_v),
              name_of(t.filter));
  }
  for (std::size_t i = 0; i < scene.images.size() && out.good(); ++i) {
    const TextureImage& image = scene.images[i];
    out.print("image {}\n    size={}x{}\n    format={}\n    bytes={}\n", i, image.width,
              image.height, name_of(image.format), image.bytes());
  }
}

void print_light(const Light& light, TextWriter& out) {
  out.print("light\n    kind={}\n", name_of(light.kind));
  if (light.kind != LightKind::directional) print_vector("position", Vec3d(light.position), out);
  if (light.kind != LightKind::point) print_vector("direction", Vec3d(light.direction), out);
  print_vector("intensity", Vec3d(light.intensity), out);
  if (light.kind == LightKind::spot) {
    out.print("    angles=({:f},{:f})\n", light.inner_angle, light.outer_angle);
  }
}

void print_environment(const Environment& environment, TextWriter& out) {
  if (environment == Environment()) return;
  out.print("environment\n    kind={}\n", name_of(environment.kind));
  if (environment.image != kNoImage) {
    out.print("    image={}\n", static_cast<std::uint32_t>(environment.image));
  }
  print_vector("colour", Vec3d(environment.colour), out);
  out.print("    rotation={:f}\n", environment.rotation);
}

}  // namespace

void print_layered(const LayeredMaterial& material, TextWriter& out) {
  static const LayeredMaterial kUsual;
  const char* separator = "";
  const auto separate = [&] {
    out.print("{}", separator);
    separator = ", ";
  };
  out.print("layered(");
  for (const LayeredColour& colour : layered_colours()) {
    if (material.*colour.member == kUsual.*colour.member && !is_always_said(colour.name)) continue;
    separate();
    print_colour(colour.name, material.*colour.member, out);
  }
  for (const LayeredNumber& number : layered_numbers()) {
    if (material.*number.member == kUsual.*number.member && !is_always_said(number.name)) continue;
    separate();
    out.print("{}={:f}", number.name, material.*number.member);
  }
  if (material.model != kUsual.model) out.print(", model={}", name_of(material.model));
  if (material.alpha_mode != kUsual.alpha_mode) {
    out.print(", alpha_mode={}", name_of(material.alpha_mode));
  }
  if (material.unlit != 0) out.print(", unlit");
  if (material.double_sided == 0) out.print(", single_sided");
  for (std::size_t i = 0; i < kMapUseCount; ++i) {
    if (material.maps[i].texture == kNoTexture) continue;
    out.print(", {}_map={}", map_name(static_cast<MapUse>(i)),
              static_cast<std::uint32_t>(material.maps[i].texture));
  }
  out.print(")");
}

void print_material(const SceneView& scene, MaterialId id, TextWriter& out) {
  out.print("    material=");
  std::visit(PrintMaterial{scene, out}, scene.materials[index_of(id)]);
  out.print("\n");
}

void print_camera(const Camera& camera, TextWriter& out) {
  print_vector("lookfrom", camera.look_from, out);
  print_vector("lookat", camera.look_at, out);
  print_vector("up", camera.up, out);
  if (camera.orthographic_height > 0) {
    out.print("    orthographic_height={:f}\n", camera.orthographic_height);
  } else {
    out.print("    vertical_fov={:f}\n", camera.vertical_fov);
  }
  out.print("    aperture={:f}\n", camera.aperture);
  out.print("    focus_distance={:f}\n", camera.focus_distance);
}

void print_looks(const SceneView& scene, TextWriter& out) {
  print_textures(scene, out);
  for (const Light& light : scene.lights) {
    if (out.good()) print_light(light, out);
  }
  print_environment(scene.environment, out);
  for (const NamedCamera& camera : scene.cameras) {
    if (!out.good()) return;
    out.print("camera {}\n", name_of(camera));
    print_camera(camera.camera, out);
  }
}

}  // namespace dapple
