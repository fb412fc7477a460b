// The two classic laws of parallel speed-up, and how a serial fraction is fitted to measurements.
#pragma once

#include <optional>
#include <span>

namespace dapple::scaling {

// Amdahl: the work is fixed and a fraction s of it runs on one thread, so n threads are
//     1 / (s + (1 - s) / n)
// times as fast as one [Amdahl67].
[[nodiscard]] double amdahl_speedup(double serial_fraction, double threads);

// Gustafson: the work grows with the threads and a fraction s of the time goes to what one thread
// does alone, so n threads do
//     n - s (n - 1)
// times as much in the same time [Gustafson88].
[[nodiscard]] double gustafson_speedup(double serial_fraction, double threads);

struct SpeedupPoint {
  double threads = 1;
  double speedup = 1;
};

// The serial fraction of least squared error: in the time 1 / speedup for Amdahl's law, in the
// speed-up itself for Gustafson's; both are linear in s. It is not held to [0, 1]: below 0 means
// that threads gained more than their number (caches, or noise). Nothing without a point of more
// than one thread.
[[nodiscard]] std::optional<double> fit_amdahl(std::span<const SpeedupPoint> points);
[[nodiscard]] std::optional<double> fit_gustafson(std::span<const SpeedupPoint> points);

}  // namespace dapple::scaling
