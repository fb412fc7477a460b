#include "dapple/view_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dapple {
namespace {

constexpr int kClassicSamples = 16, kModelSamples = 64;
constexpr int kClassicDepth = 5, kModelDepth = 12;

std::string text_or_nothing(const Arguments& arguments, std::string_view name) {
  return arguments.given(name) ? arguments.text(name) : std::string();
}

int integer_or(const Arguments& arguments, std::string_view name, int automatic) {
  const int value = arguments.small_integer(name);
  return value == 0 ? automatic : value;
}

// Width over height of the pictures that a file means; 0: any.
Expected<double> meant_aspect(const SceneInput& input, const ViewOptions& options) {
  const PictureShape& pictures = input.pictures;
  if (pictures.resolution) return double((*pictures.resolution)[0]) / (*pictures.resolution)[1];
  if (pictures.camera_aspects.empty() || options.orbit || options.target) return 0;
  if (options.camera.empty()) return pictures.camera_aspects[0];
  return camera_index(input.view().cameras, options.camera).map([&](std::size_t i) {
    return pictures.camera_aspects[i];
  });
}

// The side of a picture that follows from the other one and its shape.
Expected<int> side(double pixels, double aspect, const Arguments& arguments) {
  const double rounded = std::max(std::floor(pixels + 0.5), 1.0);
  if (rounded <= kMaxImageSide) return static_cast<int>(rounded);
  return fail(
      Errc::bad_data, arguments.text("SCENE"),
      fmt::format("its picture is {:.6g} times as wide as high, and a side of {:.6g} is more "
                  "than {}; give --width and --height",
                  aspect, rounded, kMaxImageSide));
}

}  // namespace

ImportOptions import_options_from(const Arguments& arguments) {
  ImportOptions options;
  options.scene = text_or_nothing(arguments, "scene");
  options.variant = text_or_nothing(arguments, "variant");
  if (arguments.given("time")) options.time = arguments.number("time");
  options.keep_going = arguments.given("keep-going");
  options.point_radius = arguments.number("point-radius");
  return options;
}

Expected<ViewOptions> view_options_from(const Arguments& arguments) {
  ViewOptions options;
  options.camera = text_or_nothing(arguments, "camera");
  options.environment = text_or_nothing(arguments, "environment");
  if (arguments.given("orbit")) {
    const auto [theta, phi, radius] = arguments.triple("orbit");
    if (!(radius > 0)) return fail(Errc::usage, "--orbit", "the radius is not above 0");
    options.orbit = Orbit{theta, phi, radius};
  }
  if (arguments.given("target")) {
    const auto [x, y, z] = arguments.triple("target");
    options.target = Vec3d(x, y, z);
  }
  if (!options.camera.empty() && (options.orbit || options.target)) {
    return fail(Errc::usage, "--camera", "not together with --orbit or --target");
  }
  if (arguments.given("fov")) {
    options.fov = arguments.number("fov");
    if (!(*options.fov > 0 && *options.fov < 180)) {
      return fail(Errc::usage, "--fov", "not between 0 and 180 degrees");
    }
  }
  if (arguments.given("rotate")) options.rotation = arguments.real("rotate");
  return options;
}

RenderSettings settings_from(const Arguments& arguments, bool classic) {
  RenderSettings settings;
  settings.width = arguments.small_integer("width");
  settings.height = arguments.small_integer("height");
  settings.samples_per_pixel =
      integer_or(arguments, "spp", classic ? kClassicSamples : kModelSamples);
  settings.max_scatterings = integer_or(arguments, "depth", classic ? kClassicDepth : kModelDepth);
  settings.seed = static_cast<std::uint64_t>(arguments.integer("seed"));
  settings.filter = parse_filter(arguments.text("filter")).value();
  settings.transparent_background = arguments.given("transparent");
  settings.clamp_indirect = static_cast<float>(arguments.number("clamp-indirect"));
  return settings;
}

Status check_classic_options(const Arguments& arguments) {
  for (const char* name : {"transparent", "rotate", "filter", "clamp-indirect"}) {
    if (!arguments.given(name)) continue;
    return fail(Errc::usage, fmt::format("--{}", name),
                fmt::format("does not apply to the classic scene {} under its own sky",
                            arguments.text("SCENE")));
  }
  return {};
}

Expected<std::array<int, 2>> picture_size(const Arguments& arguments, const SceneInput& input,
                                          const ViewOptions& options) {
  const auto aspect = meant_aspect(input, options);
  if (!aspect) return tl::unexpected(aspect.error());
  const bool has_width = arguments.given("width"), has_height = arguments.given("height");
  std::array<int, 2> size = {arguments.small_integer("width"), arguments.small_integer("height")};
  if ((has_width && has_height) || *aspect == 0) return size;
  if (!has_width && !has_height && input.pictures.resolution) return *input.pictures.resolution;
  const double other = has_height ? size[1] * *aspect : size[0] / *aspect;
  return side(other, *aspect, arguments).map([&](int pixels) {
    size[has_height ? 0 : 1] = pixels;
    return size;
  });
}

ToneMap tone_map_from(const Arguments& arguments, bool classic) {
  const std::string name = arguments.text("tone-map");
  if (name == "auto") return classic ? ToneMap::none : ToneMap::neutral;
  return parse_tone_map(name).value();
}

}  // namespace dapple
