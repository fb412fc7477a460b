#include "import/pbrt/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/pbrt/environment_image.h"
#include "import/text.h"

namespace dapple::pbrt {
namespace {

constexpr float kRadians = 0.01745329251994329577f;  // in a degree

Expected<Vec3f> radiance(const Context& context, const Params& params, std::string_view name) {
  const auto given = colour(context, params, name, ColourKind::emission);
  if (!given) return tl::unexpected(given.error());
  Vec3f scale(1, 1, 1);
  if (const Param* param = params.find("scale", {"float"})) {
    if (!param->numbers.empty()) {
      const float s = to_float(param->numbers[0]);
      scale = {s, s, s};
    }
  } else if (const auto old = colour(context, params, "scale", ColourKind::reflectance);
             old && *old) {
    scale = **old;
  }
  const Vec3f l = scale * given->value_or(Vec3f(1, 1, 1));
  return Vec3f(std::max(l.x, 0.0f), std::max(l.y, 0.0f), std::max(l.z, 0.0f));
}

Vec3f single(const Vec3d& v) { return {to_float(v.x), to_float(v.y), to_float(v.z)}; }

std::optional<Vec3f> direction(const Transformd& to_scene, const Vec3d& v) {
  const Vec3d turned = to_scene.vector(v);
  const double size = length(turned);
  if (!(size > 0 && std::isfinite(size))) return std::nullopt;
  return single(turned / size);
}

Status add_infinite(const Context& context, const Transformd& to_scene, const Params& params) {
  const auto l = radiance(context, params, "L");
  if (!l) return tl::unexpected(l.error());
  Environment& environment = context.import.builder().environment();
  const bool is_first = environment.kind == EnvironmentKind::classic_sky;
  std::string file = params.text("filename", "");
  if (file.empty()) file = params.text("mapname", "");
  if (!is_first && !(file.empty() && environment.kind == EnvironmentKind::constant)) {
    context.warn(params.place(), "one infinite light more than can be used");
    return {};
  }
  if (file.empty()) {
    environment.colour = is_first ? *l : environment.colour + *l;
    environment.kind = EnvironmentKind::constant;
    return {};
  }
  const auto image = environment_image(context, to_scene, file, params.place());
  if (!image) return tl::unexpected(image.error());
  environment = {EnvironmentKind::image, *image, *l, 0};
  return {};
}

}  // namespace

Status add_light(const Context& context, const Transformd& to_world, const std::string& kind,
                 const Params& params) {
  const Transformd to_scene = context.to_scene * to_world;
  Light light;
  const Vec3d from = params.vector("from").value_or(Vec3d());
  const Vec3d to = params.vector("to").value_or(Vec3d(0, 0, 1));
  const char* name = kind == "distant" ? "L" : "I";
  if (kind == "infinite") {
    if (auto added = add_infinite(context, to_scene, params); !added) return added;
    context.warn_of_unused(params);
    return {};
  }
  light.kind = kind == "point"  ? LightKind::point
               : kind == "spot" ? LightKind::spot
                                : LightKind::directional;
  if (kind != "point" && kind != "spot" && kind != "distant") {
    context.warn(params.place(), fmt::format("lights '{:.40}' are left out", kind));
    return {};
  }
  const auto intensity = radiance(context, params, name);
  if (!intensity) return tl::unexpected(intensity.error());
  light.intensity = *intensity;
  light.position = single(to_scene.point(from));
  if (kind != "point") {
    const auto way = direction(to_scene, to - from);
    if (!way) return fail(Errc::bad_data, params.place(), "the light has no direction");
    light.direction = *way;
  }
  if (kind == "spot") {
    const double cone = std::clamp(params.number("coneangle", 30), 0.0, 90.0);
    const double delta = std::clamp(params.number("conedeltaangle", 5), 0.0, cone);
    light.outer_angle = to_float(cone) * kRadians;
    light.inner_angle = to_float(cone - delta) * kRadians;
  }
  if (!is_finite(light.position)) {
    return fail(Errc::bad_data, params.place(), "the light's position is not finite");
  }
  context.import.builder().add_light(light);
  context.warn_of_unused(params);
  return {};
}

Expected<Vec3f> area_light(const Context& context, const std::string& kind, const Params& params) {
  if (kind != "diffuse" && kind != "area") {
    context.warn(params.place(), fmt::format("the light '{:.40}' is taken for 'diffuse'", kind));
  }
  auto l = radiance(context, params, "L");
  for (const char* known : {"twosided", "samples", "nsamples"}) params.find(known, {""});
  context.warn_of_unused(params);
  return l;
}

}  // namespace dapple::pbrt
