#include "common/stop_signal.h"

#include <csignal>

namespace dapple {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void ask_to_stop(int) { stop_asked.store(true); }

void catch_signal(int number) {
  struct sigaction old {};
  if (sigaction(number, nullptr, &old) != 0 || old.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

}  // namespace

const std::atomic<bool>& catch_stop_signals() {
  catch_signal(SIGINT);
  catch_signal(SIGTERM);
  catch_signal(SIGHUP);
  return stop_asked;
}

Status check_stop() {
  if (stop_asked.load()) return fail(Errc::interrupted, "", "stopped by a signal");
  return {};
}

}  // namespace dapple
