// The progress of a long rendering, on a terminal only.
#pragma once

#include <cstddef>
#include <string>

#include "common/clock.h"

namespace dapple {

struct ProgressState {
  double fraction = 0;            // of the work, from 0 to 1
  double samples_per_second = 0;  // paths from the camera
  double seconds_left = 0;
};

// " 42% [=====>      ] 3.42 Msamples/s, 0:03 left": at most `columns` long; the bar takes what
// the words leave.
[[nodiscard]] std::string progress_line(const ProgressState& state, std::size_t columns);

// "1:05", "2:00:07".
[[nodiscard]] std::string duration_text(double seconds);
// "950", "3.42 M", "1.20 G": three digits that count.
[[nodiscard]] std::string scaled_text(double value);

// Draws on standard error when that is a terminal, once the work has taken a second; the line is
// gone when the bar is.
class ProgressBar {
 public:
  // `samples` is the number of samples in the whole picture.
  ProgressBar(bool wanted, double samples);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Not from two threads at once.
  void update(std::size_t done, std::size_t total);

 private:
  bool enabled_;
  bool drawn_ = false;
  double samples_;
  double next_draw_ = 1.0;  // seconds on the clock
  Clock clock_;
};

}  // namespace dapple
