#include "dapple/scaling/study.h"

#include <optional>

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

class Study {
 public:
  Study(const std::vector<std::unique_ptr<Workload>>& workloads, const StudySettings& settings,
        const StudyProgress& progress)
      : workloads_(workloads), settings_(settings), progress_(progress) {
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
      if (auto status = progress_(done_++, size * static_cast<std::size_t>(settings_.rounds + 1));
          !status) {
        return status;
      }
      auto sample = run_once(result_.plan[turn]);
      if (!sample) return tl::unexpected(sample.error());
      if (round >= 0) result_.samples[turn].push_back(std::move(*sample));
    }
    return {};
  }

  Expected<Sample> run_once(const Configuration& configuration) {
    const Team team(configuration.threads, settings_.pin);
    if (!team.pinned()) result_.pinned = false;
    Workload& workload = workload_of(configuration.work);
    if (auto status = workload.prepare(configuration.factor); !status) {
      return tl::unexpected(status.error());
    }
    return workload.run(configuration.factor);
  }

  Workload& workload_of(WorkKind kind) const {
    std::size_t i = 0;
    while (workloads_[i]->kind() != kind) ++i;
    return *workloads_[i];
  }

  const std::vector<std::unique_ptr<Workload>>& workloads_;
  const StudySettings& settings_;
  const StudyProgress& progress_;
  Measurements result_;
  std::size_t done_ = 0;
};

}  // namespace

Expected<Measurements> run_study(const std::vector<std::unique_ptr<Workload>>& workloads,
                                 const StudySettings& settings, const StudyProgress& progress) {
  return Study(workloads, settings, progress).run();
}

}  // namespace dapple::scaling
