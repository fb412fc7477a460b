#include "import/gltf/lights_cameras.h"

#include <fmt/format.h>

#include <numbers>

#include "scene/validate.h"

namespace dapple::gltf {
namespace {

constexpr const char* kLights = "KHR_lights_punctual";
constexpr double kDegrees = 180 / std::numbers::pi;

// A direction of the node in the world; its own if the node is flat in that direction.
Vec3d direction(const Transformd& to_world, const Vec3d& local) {
  const Vec3d d = to_world.vector(local);
  const double norm = length(d);
  return norm > 0 && std::isfinite(norm) ? d / norm : local;
}

Camera camera_at(const Transformd& to_world, const JsonValue& json) {
  Camera camera;
  camera.look_from = to_world.point(Vec3d());
  camera.look_at = camera.look_from + direction(to_world, {0, 0, -1});
  camera.up = direction(to_world, {0, 1, 0});
  camera.aperture = 0;
  camera.focus_distance = 1;
  camera.vertical_fov = 45;
  if (json["type"].text() == "orthographic") {
    camera.orthographic_height = 2 * std::fabs(json["orthographic"]["ymag"].number_or(1));
  } else {
    camera.vertical_fov = json["perspective"]["yfov"].number_or(1) * kDegrees;
  }
  return camera;
}

// Width over height; 0 where the file leaves it open.
double aspect_of(const JsonValue& json) {
  if (json["type"].text() != "orthographic") return json["perspective"]["aspectRatio"].number_or(0);
  const JsonValue& magnification = json["orthographic"];
  return std::fabs(magnification["xmag"].number_or(0) / magnification["ymag"].number_or(1));
}

std::string camera_name(const JsonValue& node, const JsonValue& camera) {
  return node.has("name") ? node["name"].text() : camera["name"].text();
}

Vec3f colour_of(const JsonValue& light) {
  Vec3f colour;
  for (std::size_t i = 0; i < 3; ++i) {
    colour[static_cast<int>(i)] = static_cast<float>(light["color"][i].number_or(1));
  }
  return colour;
}

// Files say candela and lux; light in scenes is radiant.
constexpr double kLumensPerWatt = 683;

Light light_at(const Transformd& to_world, const JsonValue& json) {
  Light light;
  const std::string& type = json["type"].text();
  light.kind = type == "spot"          ? LightKind::spot
               : type == "directional" ? LightKind::directional
                                       : LightKind::point;
  light.position = Vec3f(to_world.point(Vec3d()));
  light.direction = Vec3f(direction(to_world, {0, 0, -1}));
  light.intensity =
      static_cast<float>(json["intensity"].number_or(1) / kLumensPerWatt) * colour_of(json);
  const JsonValue& spot = json["spot"];
  light.inner_angle = static_cast<float>(spot["innerConeAngle"].number_or(0));
  light.outer_angle = static_cast<float>(spot["outerConeAngle"].number_or(std::numbers::pi / 4));
  return light;
}

}  // namespace

Status add_cameras(const Context& context, const std::vector<PlacedNode>& nodes) {
  const JsonValue& cameras = context.document["cameras"];
  for (const PlacedNode& node : nodes) {
    const JsonValue& json = context.document["nodes"][node.index];
    if (!json.has("camera")) continue;
    const std::string pointer = fmt::format("/nodes/{}/camera", node.index);
    const auto index = json["camera"].index();
    if (!index || *index >= cameras.size()) {
      return context.document.error(pointer, "the camera does not exist");
    }
    const Camera camera = camera_at(node.to_world, cameras[*index]);
    if (const auto valid = validate(camera); !valid) {
      const auto error = context.document.error(pointer, valid.error().message);
      if (auto ok = context.tolerate(error.value()); !ok) return ok;
      continue;
    }
    context.builder.add_camera(camera_name(json, cameras[*index]), camera,
                               aspect_of(cameras[*index]));
  }
  return {};
}

Status add_lights(const Context& context, const std::vector<PlacedNode>& nodes) {
  const JsonValue& lights = context.document["extensions"][kLights]["lights"];
  bool any = false;
  for (const PlacedNode& node : nodes) {
    const JsonValue& use = context.document["nodes"][node.index]["extensions"][kLights];
    if (!use.is_object()) continue;
    const auto index = use["light"].index();
    if (!index || *index >= lights.size()) {
      return context.document.error(fmt::format("/nodes/{}/extensions/{}", node.index, kLights),
                                    "the light does not exist");
    }
    const std::string& type = lights[*index]["type"].text();
    if (type != "point" && type != "spot" && type != "directional") {
      context.warn(fmt::format("/extensions/{}/lights/{}", kLights, *index),
                   "lights of type " + type + " are not known and left out");
      continue;
    }
    context.builder.add_light(light_at(node.to_world, lights[*index]));
    any = true;
  }
  context.builder.environment().kind = any ? EnvironmentKind::none : EnvironmentKind::studio;
  return {};
}

}  // namespace dapple::gltf
