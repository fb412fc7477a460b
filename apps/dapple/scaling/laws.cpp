#include "dapple/scaling/laws.h"

namespace dapple::scaling {
namespace {

// The s of least squares in y = s x.
class SlopeFit {
 public:
  void add(double x, double y) {
    xy_ += x * y;
    xx_ += x * x;
  }
  std::optional<double> slope() const {
    if (xx_ == 0) return std::nullopt;
    return xy_ / xx_;
  }

 private:
  double xy_ = 0, xx_ = 0;
};

}  // namespace

double amdahl_speedup(double serial_fraction, double threads) {
  return 1 / (serial_fraction + (1 - serial_fraction) / threads);
}

double gustafson_speedup(double serial_fraction, double threads) {
  return threads - serial_fraction * (threads - 1);
}

std::optional<double> fit_amdahl(std::span<const SpeedupPoint> points) {
  SlopeFit fit;
  for (const SpeedupPoint& p : points) fit.add(1 - 1 / p.threads, 1 / p.speedup - 1 / p.threads);
  return fit.slope();
}

std::optional<double> fit_gustafson(std::span<const SpeedupPoint> points) {
  SlopeFit fit;
  for (const SpeedupPoint& p : points) fit.add(p.threads - 1, p.threads - p.speedup);
  return fit.slope();
}

}  // namespace dapple::scaling
