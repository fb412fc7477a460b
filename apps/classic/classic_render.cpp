#include <fmt/format.h>

#include <string>

#include "accel/kernels/dispatch.h"
#include "classic/classic_program.h"
#include "common/clock.h"
#include "common/program.h"
#include "common/scene_argument.h"
#include "common/standard_output.h"
#include "common/stop_signal.h"
#include "image/formats.h"
#include "render/render_job.h"
#include "scene_file/scene_source.h"
#include "util/parse_number.h"

namespace dapple {
namespace {

// OUTFILE NX NY NS [SCENE]
struct Job {
  std::string output;
  RenderSettings settings;
  std::string scene = "nice";
};

Expected<Job> parse_job(const std::vector<std::string>& values) {
  Job job;
  job.output = values[0];
  const auto read = [&](std::size_t index, const char* name, int high, int& number) -> Status {
    const auto value = parse_integer(values[index], name, 1, high);
    if (!value) return tl::unexpected(value.error());
    number = static_cast<int>(*value);
    return {};
  };
  const Status status =
      read(1, "NX", kMaxImageSide, job.settings.width)
          .and_then([&] { return read(2, "NY", kMaxImageSide, job.settings.height); })
          .and_then(
              [&] { return read(3, "NS", kMaxSamplesPerPixel, job.settings.samples_per_pixel); })
          .and_then([&] { return validate(job.settings); });
  if (!status) return tl::unexpected(status.error());
  if (values.size() > 4) job.scene = values[4];
  return job;
}

// Remembers the first failure: a picture that took hours is still worth writing.
class Lines {
 public:
  void print(const std::string& line) {
    const Status printed = print_output(line);
    if (status_) status_ = printed;
  }
  const Status& status() const { return status_; }

 private:
  Status status_;
};

Expected<Image> render_timed(const Job& job, AccelKind kind, Lines& lines) {
  RenderControl control;
  control.cancel = &catch_stop_signals();
  if (is_scene_file(job.scene)) lines.print(fmt::format("Reading scene from {}...\n", job.scene));
  VerifyOptions options;
  // The fast structure reads nothing of a shape but what the stored hierarchy holds.
  if (kind == AccelKind::fast) options.scope = VerifyScope::bvh_only;
  const auto scene = SceneSource::open(job.scene, options);
  if (!scene) return tl::unexpected(scene.error());
  Clock clock;
  const PreparedScene prepared(scene->view(), make_accel(kind, scene->view()));
  if (kind != AccelKind::linear) {
    lines.print(fmt::format("Scene BVH construction in {:f}s.\n", clock.seconds()));
  }
  clock = Clock();
  auto result = render(prepared, job.settings, control);
  if (!result) {
    Error error = result.error();
    if (error.code == Errc::bad_data) error.place = job.scene + ": " + error.place;
    return tl::unexpected(std::move(error));
  }
  lines.print(fmt::format("Rendering in {:f}s.\n", clock.seconds()));
  return std::move(result->image);
}

}  // namespace

Status classic_render(const ClassicArguments& arguments, AccelKind kind) {
  survive_closed_pipes();
  const auto job = parse_job(arguments.values);
  if (!job) return tl::unexpected(job.error());
  if (auto status = check_output(job->output); !status) return status;
  if (auto status = check_isa_override(); !status) return status;
  Lines lines;
  const auto image = render_timed(*job, kind, lines);
  if (!image) return tl::unexpected(image.error());
  ImageWriteOptions options;
  options.transfer = Transfer::gamma2;
  if (auto status = write_image(job->output, *image, options); !status) return status;
  return lines.status();
}

}  // namespace dapple
