#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "accel/kernels/dispatch.h"
#include "common/clock.h"
#include "common/program.h"
#include "common/standard_output.h"
#include "common/stop_signal.h"
#include "dapple/commands.h"
#include "dapple/common_options.h"
#include "dapple/progress_bar.h"
#include "image/formats.h"
#include "parallel/parallel.h"
#include "render/render_job.h"

namespace dapple {
namespace {

RenderSettings settings_from(const Arguments& arguments) {
  RenderSettings settings;
  settings.width = arguments.small_integer("width");
  settings.height = arguments.small_integer("height");
  settings.samples_per_pixel = arguments.small_integer("spp");
  settings.max_scatterings = arguments.small_integer("depth");
  settings.seed = static_cast<std::uint64_t>(arguments.integer("seed"));
  return settings;
}

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
  double load_seconds = 0, build_seconds = 0, render_seconds = 0, write_seconds = 0;
  std::uint64_t dropped_samples = 0;

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

Expected<RenderResult> render_scene(const SceneView& scene, bool show_progress, Report& report) {
  Clock clock;
  const PreparedScene prepared(scene, make_accel(report.accel, scene));
  report.build_seconds = lap(clock);
  ProgressBar bar(show_progress, report.samples());
  RenderControl control;
  control.cancel = &catch_stop_signals();
  control.progress = [&](std::size_t done, std::size_t total) { bar.update(done, total); };
  auto result = render(prepared, report.settings, control);
  report.render_seconds = lap(clock);
  return result;
}

Status print_report(const Report& report, const Arguments& arguments) {
  if (report.dropped_samples > 0) {
    print_message(fmt::format("dapple: warning: {} samples were not finite and count as black\n",
                              report.dropped_samples));
  }
  if (arguments.given("json")) return print_output(as_json(report, arguments));
  if (!arguments.given("quiet")) print_message(as_line(report, arguments.text("output")));
  return {};
}

}  // namespace

Expected<int> run_render(const Arguments& arguments) {
  survive_closed_pipes();
  catch_stop_signals();
  const std::string output = arguments.text("output");
  Report report;
  report.settings = settings_from(arguments);
  report.accel = parse_accel_kind(arguments.text("accel")).value();
  if (auto status = validate(report.settings)
                        .and_then([&] { return set_up_computing(arguments); })
                        .and_then([&] { return check_output(output); });
      !status) {
    return tl::unexpected(status.error());
  }

  Clock clock;
  const auto scene = open_scene(arguments, scope_for(report.accel));
  if (!scene) return tl::unexpected(scene.error());
  report.load_seconds = lap(clock);
  if (auto status = check_stop(); !status) return tl::unexpected(status.error());
  const auto result = render_scene(scene->view(), !arguments.given("quiet"), report);
  if (!result) return tl::unexpected(result.error());
  report.dropped_samples = result->dropped_samples;

  clock = Clock();
  if (auto status = write_image(output, result->image, write_options_from(arguments)); !status) {
    return tl::unexpected(status.error());
  }
  report.write_seconds = lap(clock);
  return print_report(report, arguments).map([] { return 0; });
}

}  // namespace dapple
