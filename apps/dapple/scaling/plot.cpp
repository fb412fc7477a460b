#include "dapple/scaling/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace dapple::scaling {
namespace {

// Everything in pixels of a picture of this size.
constexpr double kWidth = 560, kHeight = 420;
constexpr double kLeft = 64, kRight = 16, kTop = 36, kBottom = 112;
constexpr double kLegendRow = 16;

constexpr std::array<const char*, 4> kDashes = {"none", "7 4", "2 3", "9 3 2 3"};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// From figures to pixels.
struct Axes {
  std::vector<double> x_ticks, y_ticks;

  double x(double value) const {
    const double low = x_ticks.front(), high = std::max(x_ticks.back(), low + 1);
    return kLeft + 16 + (value - low) / (high - low) * (kWidth - kLeft - kRight - 32);
  }
  double y(double value) const {
    return kHeight - kBottom - value / y_ticks.back() * (kHeight - kTop - kBottom);
  }
};

Axes make_axes(const Plot& plot) {
  std::set<double> xs;
  double largest = 0;
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) {
      xs.insert(point.x);
      largest = std::max({largest, point.y.value, point.y.high});
    }
  }
  for (const PlotGuide& guide : plot.guides) {
    for (const PlotPoint& point : guide.points) largest = std::max(largest, point.y.value);
  }
  if (xs.empty()) xs.insert(1);
  return {{xs.begin(), xs.end()}, round_ticks(largest)};
}

class Svg {
 public:
  explicit Svg(const Plot& plot) : plot_(plot), axes_(make_axes(plot)) {}

  std::string text() {
    out_ = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 "
        "{0:g} {1:g}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n"
        "<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"white\"/>\n",
        kWidth, kHeight);
    label(kWidth / 2, 20, plot_.title, "middle", " font-size=\"14\" font-weight=\"bold\"");
    draw_axes();
    for (const PlotGuide& guide : plot_.guides) {
      line(guide.points, "#888888", 1, "none");
    }
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_series(i);
    draw_legend();
    if (!plot_.note.empty()) label(8, kHeight - 8, plot_.note, "start", " font-style=\"italic\"");
    return out_ + "</svg>\n";
  }

 private:
  void label(double x, double y, const std::string& text, const char* anchor,
             const char* more = "") {
    out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                        anchor, more, escaped(text));
  }

  void segment(double x1, double y1, double x2, double y2, const char* colour, double width = 1,
               const char* dash = "none") {
    out_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"{:g}\" stroke-dasharray=\"{}\"/>\n",
        x1, y1, x2, y2, colour, width, dash);
  }

  void line(const std::vector<PlotPoint>& points, const char* colour, double width,
            const char* dash) {
    std::string places;
    for (const PlotPoint& p : points) {
      places += fmt::format("{:.1f},{:.1f} ", axes_.x(p.x), axes_.y(p.y.value));
    }
    out_ += fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" "
        "stroke-dasharray=\"{}\"/>\n",
        places, colour, width, dash);
  }

  void draw_axes() {
    const double bottom = kHeight - kBottom, right = kWidth - kRight;
    if (plot_.doubtful_from > 0 && plot_.doubtful_from < axes_.x_ticks.back()) {
      const double from = axes_.x(plot_.doubtful_from) + 12;
      out_ += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#eeeeee\"/>\n",
          from, kTop, right - from, bottom - kTop);
    }
    for (const double tick : axes_.y_ticks) {
      segment(kLeft, axes_.y(tick), right, axes_.y(tick), "#dddddd");
      label(kLeft - 6, axes_.y(tick) + 4, fmt::format("{:g}", tick), "end");
    }
    for (const double tick : axes_.x_ticks) {
      segment(axes_.x(tick), bottom, axes_.x(tick), bottom + 5, "black");
      label(axes_.x(tick), bottom + 19, fmt::format("{:g}", tick), "middle");
    }
    segment(kLeft, bottom, right, bottom, "black");
    segment(kLeft, kTop, kLeft, bottom, "black");
    label((kLeft + right) / 2, bottom + 36, plot_.x_label, "middle");
    out_ += fmt::format("<g transform=\"translate(16 {:.1f}) rotate(-90)\">", (kTop + bottom) / 2);
    label(0, 0, plot_.y_label, "middle");
    out_ += "</g>\n";
  }

  // A circle, a square, a triangle, a diamond: filled and empty in turn.
  void mark(std::size_t kind, double x, double y) {
    const char* const fill = kind % 2 == 0 ? "black" : "white";
    switch (kind % 4) {
      case 0:
        out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"", x, y);
        break;
      case 1:
        out_ +=
            fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\"", x - 4, y - 4);
        break;
      case 2:
        out_ += polygon({{x, y - 5}, {x + 5, y + 4}, {x - 5, y + 4}});
        break;
      default:
        out_ += polygon({{x, y - 5}, {x + 5, y}, {x, y + 5}, {x - 5, y}});
    }
    out_ += fmt::format(" fill=\"{}\" stroke=\"black\"/>\n", fill);
  }

  static std::string polygon(const std::vector<std::array<double, 2>>& corners) {
    std::string text = "<polygon points=\"";
    for (const auto& [x, y] : corners) text += fmt::format("{:.1f},{:.1f} ", x, y);
    return text + "\"";
  }

  void draw_series(std::size_t i) {
    const PlotSeries& series = plot_.series[i];
    line(series.points, "black", 1.6, kDashes[i % kDashes.size()]);
    for (const PlotPoint& p : series.points) {
      const double x = axes_.x(p.x), low = axes_.y(p.y.low), high = axes_.y(p.y.high);
      segment(x, low, x, high, "black");
      segment(x - 4, low, x + 4, low, "black");
      segment(x - 4, high, x + 4, high, "black");
      mark(i, x, axes_.y(p.y.value));
    }
  }

  void draw_legend() {
    std::size_t entry = 0;
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      const auto [x, y] = legend_place(entry++);
      segment(x, y - 4, x + 34, y - 4, "black", 1.6, kDashes[i % kDashes.size()]);
      mark(i, x + 17, y - 4);
      label(x + 40, y, plot_.series[i].label, "start");
    }
    for (const PlotGuide& guide : plot_.guides) {
      if (guide.label.empty()) continue;
      const auto [x, y] = legend_place(entry++);
      segment(x, y - 4, x + 34, y - 4, "#888888");
      label(x + 40, y, guide.label, "start");
    }
  }

  // Two columns below the axis.
  static std::array<double, 2> legend_place(std::size_t entry) {
    return {kLeft + static_cast<double>(entry % 2) * (kWidth - kLeft) / 2,
            kHeight - kBottom + 56 + static_cast<double>(entry / 2) * kLegendRow};
  }

  const Plot& plot_;
  Axes axes_;
  std::string out_;
};

}  // namespace

std::vector<double> round_ticks(double largest) {
  if (!(largest > 0)) largest = 1;
  double power = 1;
  while (power * 10 <= largest) power *= 10;
  while (power > largest) power /= 10;
  double step = power;
  for (const double part : {0.2, 0.5, 1.0, 2.0}) {
    step = part * power;
    if (largest / step <= 7) break;
  }
  std::vector<double> ticks = {0};
  while (ticks.back() < largest) ticks.push_back(static_cast<double>(ticks.size()) * step);
  return ticks;
}

std::string to_svg(const Plot& plot) { return Svg(plot).text(); }

}  // namespace dapple::scaling
