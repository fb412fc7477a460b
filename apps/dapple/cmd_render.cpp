#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "accel/kernels/dispatch.h"
#include "common/clock.h"
#include "common/program.h"
#include "common/standard_output.h"
#include "common/stop_signal.h"
#include "dapple/commands.h"
#include "dapple/common_options.h"
#include "dapple/progress_bar.h"
#include "dapple/view_arguments.h"
#include "image/formats.h"
#include "image/tone_map.h"
#include "image/transfer.h"
#include "parallel/parallel.h"
#include "render/film.h"
#include "render/lit_scene.h"
#include "render/render_job.h"
#include "render/sight.h"

namespace dapple {
namespace {

ImageWriteOptions write_options_from(const Arguments& arguments) {
  ImageWriteOptions options;
  options.transfer = arguments.text("transfer") == "gamma2" ? Transfer::gamma2 : Transfer::srgb;
  options.png_bits = arguments.text("bits") == "16" ? 16 : 8;
  options.exr_float = arguments.text("exr-type") == "float";
  return options;
}

// The fast structure reads nothing of a shape but what the stored hierarchy holds.
VerifyScope scope_for(AccelKind kind) {
  return kind == AccelKind::fast ? VerifyScope::bvh_only : VerifyScope::everything;
}

// What one run did, for the summary.
struct Report {
  RenderSettings settings;
  AccelKind accel = AccelKind::fast;
  BvhQuality bvh_quality = BvhQuality::medium;
  LeafForm leaf_form = LeafForm::whole;
  bool classic = true;
  bool warn_of_nothing = false;  // when no surface is seen
  double load_seconds = 0, build_seconds = 0, render_seconds = 0, write_seconds = 0;
  std::uint64_t dropped_samples = 0, cut_samples = 0;
  double clamped_radiance = 0;
  float exposure = 0;  // stops

  double samples() const {
    return static_cast<double>(settings.width) * settings.height * settings.samples_per_pixel;
  }
  double samples_per_second() const { return samples() / render_seconds; }
};

std::string as_line(const Report& report, const std::string& output) {
  return fmt::format("{}: {} x {} pixels, {} samples each, rendered in {:.3f} s ({} samples/s)\n",
                     output, report.settings.width, report.settings.height,
                     report.settings.samples_per_pixel, report.render_seconds,
                     scaled_text(report.samples_per_second()));
}

std::string as_json(const Report& report, const Arguments& arguments) {
  const nlohmann::ordered_json json = {
      {"scene", arguments.text("SCENE")},
      {"output", arguments.text("output")},
      {"width", report.settings.width},
      {"height", report.settings.height},
      {"spp", report.settings.samples_per_pixel},
      {"depth", report.settings.max_scatterings},
      {"seed", report.settings.seed},
      {"accel", accel_name(report.accel)},
      {"isa", kernels().isa},
      {"threads", thread_count()},
      {"load_seconds", report.load_seconds},
      {"build_seconds", report.build_seconds},
      {"render_seconds", report.render_seconds},
      {"write_seconds", report.write_seconds},
      {"samples_per_second", report.samples_per_second()},
      {"dropped_samples", report.dropped_samples},
      {"cut_samples", report.cut_samples},
      {"clamped_radiance", report.clamped_radiance},
      {"exposure", report.exposure},
  };
  // File names need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

// Time since the last call, on a clock that goes on.
double lap(Clock& clock) {
  const double seconds = clock.seconds();
  clock = Clock();
  return seconds;
}

void print_warning(const std::string& text) {
  print_message(fmt::format("dapple: warning: {}\n", text));
}

Expected<RenderResult> render_scene(const SceneView& scene, bool show_progress, Report& report) {
  Clock clock;
  const PreparedScene prepared(
      scene, make_accel(report.accel, scene, report.bvh_quality, report.leaf_form));
  if (report.warn_of_nothing && !sees_surfaces(prepared, report.settings)) {
    print_warning("no surface is in the camera's sight");
  }
  if (stands_in_medium(prepared)) {
    print_warning("the camera stands inside of a body whose medium is left out up to its surface");
  }
  report.build_seconds = lap(clock);
  ProgressBar bar(show_progress, report.samples());
  RenderControl control;
  control.cancel = &catch_stop_signals();
  control.progress = [&](std::size_t done, std::size_t total) { bar.update(done, total); };
  auto result = render(prepared, report.settings, control);
  report.render_seconds = lap(clock);
  return result;
}

bool is_black(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(),
                     [](const Vec3f& pixel) { return pixel == Vec3f(); });
}

void print_warnings(const Report& report, const Image& image) {
  if (report.dropped_samples > 0) {
    print_warning(
        fmt::format("{} samples were not finite and count as black", report.dropped_samples));
  }
  if (report.cut_samples > 0) {
    print_warning(fmt::format("{} samples were brighter than {:g} and count as that bright",
                              report.cut_samples, kFilmClamp));
  }
  if (is_black(image)) {
    print_warning("the picture is black: no light reaches the camera");
  }
  if (report.clamped_radiance > 0) {
    print_warning(fmt::format("clamping took {:.3g} of radiance from the mean pixel",
                              report.clamped_radiance));
  }
}

Status print_report(const Report& report, const Arguments& arguments) {
  if (arguments.given("json")) return print_output(as_json(report, arguments));
  if (!arguments.given("quiet")) print_message(as_line(report, arguments.text("output")));
  return {};
}

// Linear formats keep the radiance as it is.
bool is_display_format(const std::string& path) {
  const auto ends = [&](std::string_view ending) { return format_ending(path) == ending; };
  return ends(".png") || ends(".ppm");
}

// Lamps alone may be of any strength; surroundings are as bright as pictures are.
float exposure_for(const Arguments& arguments, const SceneView& scene, const Image& image) {
  if (arguments.given("exposure")) return static_cast<float>(arguments.real("exposure"));
  return scene.environment.kind == EnvironmentKind::none ? automatic_exposure(image) : 0.0f;
}

// A classic scene's own camera may look at the sky on purpose.
bool should_see_surfaces(const Arguments& arguments, const SceneView& scene, bool classic) {
  if (!classic) return true;
  return scene.object_count() > 0 &&
         (arguments.given("orbit") || arguments.given("target") || arguments.given("fov"));
}

// What is left of the brightest channel is less than half a step of the file.
bool is_too_dark(const Image& image, const std::string& path, const ImageWriteOptions& options) {
  float most = 0;
  for (const Vec3f& pixel : image.pixels) most = std::max({most, pixel.x, pixel.y, pixel.z});
  const bool fine = format_ending(path) == ".png" && options.png_bits == 16;
  return encode_integer(most, options.transfer, fine ? 65535 : 255) == 0;
}

// Fits radiance into what the file holds.
void expose(Image& image, float exposure, const Arguments& arguments, const Report& report) {
  const bool was_black = is_black(image);
  apply_tone_map(image, tone_map_from(arguments, report.classic), exposure);
  if (!was_black && is_too_dark(image, arguments.text("output"), write_options_from(arguments))) {
    print_warning(
        fmt::format("the picture is black: an exposure of {:g} stops leaves no light", exposure));
  }
}

// Names that promise a format we do not write: a PPM file of that name would be a trap.
Status check_format(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension();
  for (const std::string_view other :
       {".jpg", ".jpeg", ".webp", ".tif", ".tiff", ".bmp", ".gif", ".JPG", ".JPEG"}) {
    if (ending == other) {
      return fail(Errc::usage, path,
                  "this format is not written; use .png, .exr, .hdr, .pfm or .ppm");
    }
  }
  return {};
}

Status check_not_inputs(const std::string& output, const Arguments& arguments) {
  const std::string scene = arguments.text("SCENE");
  if (SceneSource::is_path(scene)) {
    if (auto status = check_not_input(output, scene); !status) return status;
  }
  if (!arguments.given("environment")) return {};
  return check_not_input(output, arguments.text("environment"));
}

// The view that the command line asks for, and the size of its picture.
struct Shot {
  EditedView view;
  std::array<int, 2> size{};
};

Expected<Shot> shot_of(const SceneInput& input, const Arguments& arguments) {
  auto options = view_options_from(arguments);
  if (!options) return tl::unexpected(options.error());
  options->frame = !input.has_camera;
  const auto size = picture_size(arguments, input, *options);
  if (!size) return tl::unexpected(size.error());
  auto view = EditedView::create(input.view(), *options, double((*size)[0]) / (*size)[1]);
  if (!view) return tl::unexpected(view.error());
  return Shot{std::move(*view), *size};
}

}  // namespace

Expected<int> run_render(const Arguments& arguments) {
  survive_closed_pipes();
  catch_stop_signals();
  const std::string output = arguments.text("output");
  Report report;
  report.accel = parse_accel_kind(arguments.text("accel")).value();
  report.bvh_quality = parse_bvh_quality(arguments.text("bvh-quality")).value();
  if (arguments.given("bvh-compact")) report.leaf_form = LeafForm::compact;
  if (auto status = validate(settings_from(arguments, true))
                        .and_then([&] { return set_up_computing(arguments); })
                        .and_then([&] { return check_format(output); })
                        .and_then([&] { return check_not_inputs(output, arguments); })
                        .and_then([&] { return check_output(output); });
      !status) {
    return tl::unexpected(status.error());
  }

  Clock clock;
  const auto input = open_scene(arguments, scope_for(report.accel));
  if (!input) return tl::unexpected(input.error());
  const auto shot = shot_of(*input, arguments);
  if (!shot) return tl::unexpected(shot.error());
  const SceneView& view = shot->view.view();
  report.load_seconds = lap(clock);
  report.classic = is_classic(view);
  report.warn_of_nothing = should_see_surfaces(arguments, view, report.classic);
  report.settings = settings_from(arguments, report.classic);
  report.settings.width = shot->size[0];
  report.settings.height = shot->size[1];
  if (auto status = validate(report.settings)
                        .and_then([&]() -> Status {
                          return report.classic ? check_classic_options(arguments) : Status();
                        })
                        .and_then(check_stop);
      !status) {
    return tl::unexpected(status.error());
  }
  auto result = render_scene(view, !arguments.given("quiet"), report);
  if (!result) return tl::unexpected(result.error());
  report.dropped_samples = result->dropped_samples;
  report.cut_samples = result->cut_samples;
  report.clamped_radiance = result->clamped_radiance;
  print_warnings(report, result->image);

  clock = Clock();
  if (is_display_format(output)) {
    report.exposure = exposure_for(arguments, view, result->image);
    expose(result->image, report.exposure, arguments, report);
  }
  if (auto status = write_image(output, result->image, write_options_from(arguments)); !status) {
    return tl::unexpected(status.error());
  }
  report.write_seconds = lap(clock);
  return print_report(report, arguments).map([] { return 0; });
}

}  // namespace dapple
