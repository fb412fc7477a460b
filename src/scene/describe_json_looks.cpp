#include "scene/describe_json_looks.h"

#include <variant>

#include "scene/describe_names.h"
#include "scene/json_text.h"
#include "scene/layered_fields.h"

namespace dapple {
namespace {

struct PrintMaterial {
  TextWriter& out;

  void operator()(const Lambertian& m) const {
    out.print("{{\"type\":\"lambertian\",");
    print_json_vector("albedo", m.albedo, out);
    out.print("}}");
  }
  void operator()(const Metal& m) const {
    out.print("{{\"type\":\"metal\",");
    print_json_vector("albedo", m.albedo, out);
    out.print(",\"fuzz\":{}}}", json_number(m.fuzz));
  }
  void operator()(const Dielectric& m) const {
    out.print("{{\"type\":\"dielectric\",\"ref_idx\":{}}}", json_number(m.ref_idx));
  }
  void operator()(const Layered& m) const {
    out.print("{{\"type\":\"layered\",\"index\":{}}}", m.index);
  }
};

// A number, or null where there is none.
template <class Id>
std::string id_or_null(Id id, Id none) {
  return id == none ? "null" : std::to_string(static_cast<std::uint32_t>(id));
}

void print_slot(MapUse use, const TextureSlot& slot, TextWriter& out) {
  out.print("\"{}\":{{\"texture\":{},\"uv_set\":{},\"to_uv\":[", map_name(use),
            static_cast<std::uint32_t>(slot.texture), slot.uv_set);
  for (int i = 0; i < 2; ++i) {
    out.print("{}[{},{},{}]", i == 0 ? "" : ",", json_number(slot.to_uv[i][0]),
              json_number(slot.to_uv[i][1]), json_number(slot.to_uv[i][2]));
  }
  out.print("]}}");
}

void print_layered(const LayeredMaterial& m, TextWriter& out) {
  out.print("{{\"model\":\"{}\",\"alpha_mode\":\"{}\",\"unlit\":{},\"double_sided\":{}",
            name_of(m.model), name_of(m.alpha_mode), m.unlit != 0, m.double_sided != 0);
  for (const LayeredColour& colour : layered_colours()) {
    out.print(",");
    print_json_vector(colour.name, m.*colour.member, out);
  }
  for (const LayeredNumber& number : layered_numbers()) {
    out.print(",\"{}\":{}", number.name, json_number(m.*number.member));
  }
  out.print(",\"maps\":{{");
  const char* separator = "";
  for (std::size_t i = 0; i < kMapUseCount; ++i) {
    if (m.maps[i].texture == kNoTexture) continue;
    out.print("{}", separator);
    print_slot(static_cast<MapUse>(i), m.maps[i], out);
    separator = ",";
  }
  out.print("}}}}");
}

void print_texture(const Texture& t, TextWriter& out) {
  out.print("{{\"image\":{},\"wrap_u\":\"{}\",\"wrap_v\":\"{}\",\"filter\":\"{}\"}}",
            static_cast<std::uint32_t>(t.image), name_of(t.wrap_u), name_of(t.wrap_v),
            name_of(t.filter));
}

void print_image(const TextureImage& image, TextWriter& out) {
  out.print("{{\"width\":{},\"height\":{},\"format\":\"{}\",\"bytes\":{}}}", image.width,
            image.height, name_of(image.format), image.bytes());
}

void print_light(const Light& light, TextWriter& out) {
  out.print("{{\"kind\":\"{}\",", name_of(light.kind));
  print_json_vector("position", light.position, out);
  out.print(",");
  print_json_vector("direction", light.direction, out);
  out.print(",");
  print_json_vector("intensity", light.intensity, out);
  out.print(",\"inner_angle\":{},\"outer_angle\":{}}}", json_number(light.inner_angle),
            json_number(light.outer_angle));
}

void print_named_camera(const NamedCamera& camera, TextWriter& out) {
  out.print("{{\"name\":{},\"camera\":", json_string(name_of(camera)));
  print_json_camera(camera.camera, out);
  out.print("}}");
}

template <class T, class Print>
void print_array(const char* name, std::span<const T> elements, Print print, TextWriter& out) {
  out.print("\"{}\":[", name);
  const char* separator = "\n";
  for (const T& element : elements) {
    if (!out.good()) return;
    out.print("{}", separator);
    print(element, out);
    separator = ",\n";
  }
  out.print("],\n");
}

}  // namespace

void print_json_camera(const Camera& camera, TextWriter& out) {
  out.print("{{");
  print_json_vector("lookfrom", camera.look_from, out);
  out.print(",");
  print_json_vector("lookat", camera.look_at, out);
  out.print(",");
  print_json_vector("up", camera.up, out);
  out.print(",\"vertical_fov\":{},\"aperture\":{},\"focus_distance\":{},",
            json_number(camera.vertical_fov), json_number(camera.aperture),
            json_number(camera.focus_distance));
  out.print("\"orthographic_height\":{}}}", json_number(camera.orthographic_height));
}

void print_json_looks(const SceneView& scene, TextWriter& out) {
  const auto print_variant = [](const Material& material, TextWriter& text) {
    std::visit(PrintMaterial{text}, material);
  };
  print_array("materials", scene.materials, print_variant, out);
  print_array("layered_materials", scene.layered_materials, print_layered, out);
  print_array("textures", scene.textures, print_texture, out);
  print_array("images", scene.images, print_image, out);
  print_array("lights", scene.lights, print_light, out);
  out.print("\"environment\":{{\"kind\":\"{}\",\"image\":{},", name_of(scene.environment.kind),
            id_or_null(scene.environment.image, kNoImage));
  print_json_vector("colour", scene.environment.colour, out);
  out.print(",\"rotation\":{}}},\n", json_number(scene.environment.rotation));
  print_array("cameras", scene.cameras, print_named_camera, out);
}

}  // namespace dapple
