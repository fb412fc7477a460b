#include "dapple/scaling/workload.h"

#include <fmt/format.h>

#include <ctime>
#include <map>

#include "accel/wide_builder.h"
#include "common/clock.h"
#include "common/stop_signal.h"
#include "render/render_job.h"
#include "scene_file/scene_source.h"

namespace dapple::scaling {
namespace {

double process_cpu_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class SampleClock {
 public:
  Sample sample(const ThreadTimes& times) const {
    Sample sample;
    sample.wall = clock_.seconds();
    sample.cpu = process_cpu_seconds() - cpu_start_;
    sample.busy = times.busy();
    return sample;
  }

 private:
  double cpu_start_ = process_cpu_seconds();
  Clock clock_;
};

class Rendering final : public Workload {
 public:
  Rendering(WorkKind kind, const SceneView& scene, const RenderSettings& settings)
      : kind_(kind), scene_view_(scene), settings_(settings) {}

  WorkKind kind() const override { return kind_; }

  Status prepare(int) override {
    if (scene_) return {};
    const AccelKind accel = kind_ == WorkKind::ray ? AccelKind::linear : AccelKind::fast;
    scene_ = std::make_unique<PreparedScene>(scene_view_, make_accel(accel, scene_view_));
    return {};
  }

  Expected<Sample> run(int factor) override {
    RenderSettings settings = settings_;
    settings.samples_per_pixel *= factor;
    ThreadTimes times;
    RenderControl control;
    control.cancel = &catch_stop_signals();
    control.thread_times = &times;
    const SampleClock clock;
    const auto picture = render(*scene_, settings, control);
    if (!picture) return tl::unexpected(picture.error());
    return clock.sample(times);
  }

 private:
  WorkKind kind_;
  const SceneView& scene_view_;
  RenderSettings settings_;
  std::unique_ptr<PreparedScene> scene_;
};

class Building final : public Workload {
 public:
  explicit Building(int objects) : objects_(objects) {}

  WorkKind kind() const override { return WorkKind::build; }

  Status prepare(int factor) override {
    if (scenes_.contains(factor)) return {};
    auto scene =
        SceneSource::open(fmt::format("spheres:{}", static_cast<std::int64_t>(objects_) * factor));
    if (!scene) return tl::unexpected(scene.error());
    scenes_.emplace(factor, std::move(*scene));
    return {};
  }

  Expected<Sample> run(int factor) override {
    ThreadTimes times;
    const SampleClock clock;
    const WideBvh bvh = build_wide_bvh(scenes_.at(factor).view(), &times);
    return clock.sample(times);
  }

 private:
  int objects_;
  std::map<int, SceneSource> scenes_;  // by factor
};

}  // namespace

std::unique_ptr<Workload> make_rendering(WorkKind kind, const SceneView& scene,
                                         const RenderSettings& settings) {
  return std::make_unique<Rendering>(kind, scene, settings);
}

std::unique_ptr<Workload> make_building(int objects) { return std::make_unique<Building>(objects); }

}  // namespace dapple::scaling
