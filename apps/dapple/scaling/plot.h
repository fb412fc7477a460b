// Line plots as SVG, made for paper: black and grey, told apart by dashes and marks.
#pragma once

#include <string>
#include <vector>

#include "dapple/scaling/bootstrap.h"

namespace dapple::scaling {

struct PlotPoint {
  double x = 0;
  Estimate y;
};

// Measurements: a mark with an error bar at each point, joined by a line.
struct PlotSeries {
  std::string label;
  std::vector<PlotPoint> points;
};

// What measurements are compared with: a thin grey line.
struct PlotGuide {
  std::string label;  // empty to leave it out of the legend
  std::vector<PlotPoint> points;
};

struct Plot {
  std::string title;
  std::string x_label, y_label;
  std::vector<PlotGuide> guides;
  std::vector<PlotSeries> series;
  std::string note;          // below the plot; empty for none
  double doubtful_from = 0;  // x beyond which the background is grey; 0 for none
};

// The x axis has a tick at every x of a point; the y axis begins at 0.
[[nodiscard]] std::string to_svg(const Plot& plot);

// Ticks at round numbers from 0 to `largest` or a little more: 4 to 8 of them.
[[nodiscard]] std::vector<double> round_ticks(double largest);

}  // namespace dapple::scaling
