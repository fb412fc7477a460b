#include "dapple/scaling/study.h"

#include <chrono>
#include <optional>
#include <thread>

#include "common/clock.h"
#include "parallel/parallel.h"
#include "parallel/pinning.h"

namespace dapple::scaling {
namespace {

// The thread count of a run, and its pinning when that is wanted.
class Team {
 public:
  Team(int threads, bool pin) : before_(thread_count()) {
    set_thread_count(threads);
    if (pin) pinned_team_.emplace(threads);
  }
  ~Team() {
    pinned_team_.reset();
    set_thread_count(before_);
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  bool pinned() const { return pinned_team_ && pinned_team_->pinned(); }

 private:
  int before_;
  std::optional<PinnedTeam> pinned_team_;
};

// How long the study may still wait or repeat.
class Patience {
 public:
  explicit Patience(double seconds) : left_(seconds) {}

  bool over() const { return left_ <= 0; }
  void spend(double seconds) { left_ -= seconds; }

  static bool disturbed(const Activity& activity, std::size_t cores) {
    return activity.cores() > kDisturbed * static_cast<double>(cores);
  }

  // Looks at the machine for a moment.
  bool finds_quiet(std::size_t cores) {
    const Clock clock;
    const ActivityMeter meter;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (!disturbed(meter.elapsed(), cores)) return true;
    spend(clock.seconds());
    return false;
  }

 private:
  double left_;
};

class Study {
 public:
  Study(const std::vector<std::unique_ptr<Workload>>& workloads, const StudySettings& settings,
        const StudyProgress& progress)
      : workloads_(workloads),
        settings_(settings),
        progress_(progress),
        patience_(settings.patience) {
    std::vector<WorkKind> works;
    for (const auto& workload : workloads) works.push_back(workload->kind());
    result_.plan = make_plan(works, settings.threads);
    result_.samples.resize(result_.plan.size());
    result_.threads = settings.threads;
    result_.rounds = settings.rounds;
    result_.pinned = settings.pin;
  }

  Expected<Measurements> run() {
    for (int round = -1; round < settings_.rounds; ++round) {
      if (auto status = run_round(round); !status) return tl::unexpected(status.error());
    }
    return std::move(result_);
  }

 private:
  // Round -1 warms up.
  Status run_round(int round) {
    const std::size_t size = result_.plan.size();
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t turn = (i + static_cast<std::size_t>(round + 1)) % size;
      if (auto status = report_progress(); !status) return status;
      const Configuration& configuration = result_.plan[turn];
      auto sample = round < 0 ? run_once(configuration) : run_undisturbed(configuration);
      if (!sample) return tl::unexpected(sample.error());
      if (round >= 0) result_.samples[turn].push_back(std::move(*sample));
      ++done_;
    }
    return {};
  }

  Status report_progress() const {
    return progress_(done_, result_.plan.size() * static_cast<std::size_t>(settings_.rounds + 1));
  }

  Expected<Sample> run_undisturbed(const Configuration& configuration) {
    while (!patience_.over() && !patience_.finds_quiet(cores_)) {
      if (auto status = report_progress(); !status) return tl::unexpected(status.error());
    }
    auto best = run_once(configuration);
    while (best && Patience::disturbed(best->activity, cores_) && !patience_.over()) {
      auto again = run_once(configuration);
      if (!again) return again;
      patience_.spend(again->wall);
      ++result_.repeated;
      if (again->activity.cores() < best->activity.cores()) best = std::move(again);
    }
    return best;
  }

  Expected<Sample> run_once(const Configuration& configuration) {
    const Team team(configuration.threads, settings_.pin);
    if (!team.pinned()) result_.pinned = false;
    Workload& workload = workload_of(configuration.work);
    if (auto status = workload.prepare(configuration.factor); !status) {
      return tl::unexpected(status.error());
    }
    const ActivityMeter meter;
    auto sample = workload.run(configuration.factor);
    if (sample) sample->activity = meter.elapsed();
    return sample;
  }

  Workload& workload_of(WorkKind kind) const {
    std::size_t i = 0;
    while (workloads_[i]->kind() != kind) ++i;
    return *workloads_[i];
  }

  const std::vector<std::unique_ptr<Workload>>& workloads_;
  const StudySettings& settings_;
  const StudyProgress& progress_;
  Patience patience_;
  std::size_t cores_ = allowed_cores().size();
  Measurements result_;
  std::size_t done_ = 0;
};

}  // namespace

Activity mean_activity(const Measurements& measurements) {
  Activity mean;
  double seconds = 0;
  for (const auto& runs : measurements.samples) {
    for (const Sample& run : runs) {
      mean.other_cores += run.activity.other_cores * run.wall;
      mean.stolen_cores += run.activity.stolen_cores * run.wall;
      seconds += run.wall;
    }
  }
  if (seconds == 0) return {};
  return {mean.other_cores / seconds, mean.stolen_cores / seconds};
}

Expected<Measurements> run_study(const std::vector<std::unique_ptr<Workload>>& workloads,
                                 const StudySettings& settings, const StudyProgress& progress) {
  return Study(workloads, settings, progress).run();
}

}  // namespace dapple::scaling
