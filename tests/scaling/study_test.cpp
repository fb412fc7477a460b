#include "dapple/scaling/study.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "parallel/parallel.h"
#include "parallel/pinning.h"
#include "scene_file/scene_source.h"

namespace dapple::scaling {
namespace {

// Writes down what it is asked to do.
class Recorder final : public Workload {
 public:
  explicit Recorder(std::string& log) : log_(log) {}

  WorkKind kind() const override { return WorkKind::build; }
  Status prepare(int) override { return {}; }
  Expected<Sample> run(int factor) override {
    log_ += fmt::format("{}x{} ", thread_count(), factor);
    if (allowed_cores().size() == 1) ++pinned_runs;
    Sample sample;
    sample.wall = 1;
    return sample;
  }

  int pinned_runs = 0;

 private:
  std::string& log_;
};

Status go_on(std::size_t, std::size_t) { return {}; }

TEST(Study, WarmsUpAndThenTakesTurns) {
  std::string log;
  std::vector<std::unique_ptr<Workload>> workloads;
  workloads.push_back(std::make_unique<Recorder>(log));
  StudySettings settings;
  settings.threads = {1, 2};
  settings.rounds = 2;
  const int threads_before = thread_count();
  const auto m = run_study(workloads, settings, go_on);
  ASSERT_TRUE(m);
  EXPECT_EQ(log, "1x1 2x1 2x2 2x1 2x2 1x1 2x2 1x1 2x1 ");
  EXPECT_EQ(static_cast<Recorder&>(*workloads[0]).pinned_runs, 9);
  EXPECT_TRUE(m->pinned);
  for (const auto& runs : m->samples) EXPECT_EQ(runs.size(), 2u);
  EXPECT_EQ(thread_count(), threads_before);
}

TEST(Study, ThreadsWanderWhenNotTied) {
  std::string log;
  std::vector<std::unique_ptr<Workload>> workloads;
  workloads.push_back(std::make_unique<Recorder>(log));
  StudySettings settings;
  settings.rounds = 1;
  settings.pin = false;
  const auto m = run_study(workloads, settings, go_on);
  ASSERT_TRUE(m);
  EXPECT_FALSE(m->pinned);
}

TEST(Study, AnErrorOfTheProgressEndsIt) {
  std::string log;
  std::vector<std::unique_ptr<Workload>> workloads;
  workloads.push_back(std::make_unique<Recorder>(log));
  StudySettings settings;
  settings.rounds = 3;
  const auto m = run_study(workloads, settings, [](std::size_t done, std::size_t total) -> Status {
    EXPECT_EQ(total, 4u);
    if (done < 2) return {};
    return fail(Errc::interrupted, "", "enough");
  });
  ASSERT_FALSE(m);
  EXPECT_EQ(m.error().code, Errc::interrupted);
  EXPECT_EQ(log, "1x1 1x1 ");
}

TEST(Study, RealWorkIsTimedThreadByThread) {
  const auto scene = SceneSource::open("rgbbox");
  ASSERT_TRUE(scene);
  const SceneView& view = scene->view();
  RenderSettings small;
  small.width = small.height = 64;
  small.samples_per_pixel = 4;
  std::vector<std::unique_ptr<Workload>> workloads;
  workloads.push_back(make_rendering(WorkKind::ray, view, small));
  workloads.push_back(make_rendering(WorkKind::ray_bvh, view, small));
  workloads.push_back(make_building(20000));
  StudySettings settings;
  settings.threads = {1, 2};
  settings.rounds = 1;
  const auto m = run_study(workloads, settings, go_on);
  ASSERT_TRUE(m);
  ASSERT_EQ(m->samples.size(), 9u);
  for (std::size_t i = 0; i < m->plan.size(); ++i) {
    const Configuration& c = m->plan[i];
    const Sample& sample = m->samples[i].at(0);
    EXPECT_GT(sample.wall, 0);
    ASSERT_EQ(sample.busy.size(), static_cast<std::size_t>(c.threads));
    std::size_t pieces = 0;
    for (const BusyTime& thread : sample.busy) {
      EXPECT_LE(thread.wall, sample.wall);
      pieces += thread.pieces;
    }
    // 2 x 2 tiles for each 4 samples.
    if (c.work == WorkKind::build) continue;
    EXPECT_EQ(pieces, 4u * static_cast<std::size_t>(c.factor));
  }
}

}  // namespace
}  // namespace dapple::scaling
