#include "dapple/progress_bar.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace dapple {
namespace {

constexpr double kSecondsBetweenDraws = 0.1;
constexpr std::size_t kDefaultColumns = 80;
constexpr std::size_t kWidestBar = 40;
constexpr std::size_t kNarrowestBar = 4;

std::size_t terminal_columns() {
  struct winsize size {};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kDefaultColumns;
  return size.ws_col;
}

void write_to_terminal(const std::string& text) {
  // A bar that cannot be drawn is no reason to stop rendering.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

std::string bar(double fraction, std::size_t width) {
  const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(width));
  std::string text(width, ' ');
  std::fill_n(text.begin(), filled, '=');
  if (filled < width) text[filled] = '>';
  return text;
}

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::clamp(seconds, 0.0, 1e9) + 0.5);
  const std::int64_t hours = whole / 3600, minutes = whole / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
  return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string scaled_text(double value) {
  constexpr std::array<const char*, 4> kPrefixes = {"", " k", " M", " G"};
  std::size_t prefix = 0;
  while (value >= 999.5 && prefix + 1 < kPrefixes.size()) {
    value /= 1000;
    ++prefix;
  }
  const int decimals = prefix == 0 || value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
  return fmt::format("{:.{}f}{}", value, decimals, kPrefixes[prefix]);
}

std::string progress_line(const ProgressState& state, std::size_t columns) {
  const double fraction = std::clamp(state.fraction, 0.0, 1.0);
  const std::string percent = fmt::format("{:3}%", static_cast<int>(fraction * 100));
  const std::string words =
      fmt::format(" {} samples/s, {} left", scaled_text(state.samples_per_second),
                  duration_text(state.seconds_left));
  const std::size_t brackets = 3;  // " [" and "]"
  const std::size_t taken = percent.size() + words.size() + brackets;
  if (columns < taken + kNarrowestBar) return (percent + words).substr(0, columns);
  const std::string drawn = bar(fraction, std::min(columns - taken, kWidestBar));
  return fmt::format("{} [{}]{}", percent, drawn, words);
}

ProgressBar::ProgressBar(bool wanted, double samples)
    : enabled_(wanted && ::isatty(STDERR_FILENO) == 1), samples_(samples) {}

ProgressBar::~ProgressBar() {
  if (drawn_) write_to_terminal("\r\033[K");
}

void ProgressBar::update(std::size_t done, std::size_t total) {
  if (!enabled_) return;
  const double seconds = clock_.seconds();
  if (seconds < next_draw_) return;
  next_draw_ = seconds + kSecondsBetweenDraws;
  ProgressState state;
  state.fraction = static_cast<double>(done) / static_cast<double>(total);
  state.samples_per_second = samples_ * state.fraction / seconds;
  state.seconds_left = seconds * (1 / state.fraction - 1);
  // The last column stays free: some terminals wrap there.
  write_to_terminal(fmt::format("\r{}\033[K", progress_line(state, terminal_columns() - 1)));
  drawn_ = true;
}

}  // namespace dapple
