#include "dapple/scaling/plot.h"

#include <gtest/gtest.h>

#include "tests/scaling/well_formed.h"

namespace dapple::scaling {
namespace {

Plot small_plot() {
  Plot plot;
  plot.title = "a < b & \"c\"";
  plot.x_label = "threads";
  plot.y_label = "seconds";
  plot.series = {{"one", {{1, {2, 1.9, 2.1}}, {2, {1, 0.9, 1.3}}}}, {"two", {{1, {4, 4, 4}}}}};
  plot.guides = {{"ideal", {{1, {2, 2, 2}}, {2, {1, 1, 1}}}}};
  return plot;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(Plot, IsWellFormedWhateverTheLabels) {
  EXPECT_EQ(xml_problem(to_svg(small_plot())), "");
  EXPECT_EQ(xml_problem(to_svg(Plot{})), "");
  EXPECT_NE(to_svg(small_plot()).find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
}

TEST(Plot, TheCheckerSeesWhatIsNotWellFormed) {
  EXPECT_NE(xml_problem("<a><b></a></b>"), "");
  EXPECT_NE(xml_problem("<a>"), "");
  EXPECT_NE(xml_problem("<a x=1/>"), "");
  EXPECT_NE(xml_problem("<a>1 & 2</a>"), "");
  EXPECT_NE(xml_problem("<a/><b/>"), "");
  EXPECT_EQ(xml_problem("<?xml version=\"1.0\"?><a x=\"1\"><b/>&amp;</a>"), "");
}

TEST(Plot, HasALineForEverySeriesAndGuideAndAMarkForEveryPoint) {
  const std::string svg = to_svg(small_plot());
  EXPECT_EQ(count(svg, "<polyline"), 3u);
  EXPECT_EQ(count(svg, "<circle"), 3u);      // two points and the legend
  EXPECT_EQ(count(svg, "width=\"8\""), 2u);  // squares: one point and the legend
  EXPECT_EQ(count(svg, "fill=\"#eeeeee\""), 0u);
  Plot doubtful = small_plot();
  doubtful.doubtful_from = 1;
  EXPECT_EQ(count(to_svg(doubtful), "fill=\"#eeeeee\""), 1u);
}

TEST(Plot, TicksAreRoundAndReachTheLargest) {
  EXPECT_EQ(round_ticks(4), (std::vector<double>{0, 1, 2, 3, 4}));
  for (const double largest : {0.0, 1e-4, 0.3, 1.0, 1.05, 7.3, 99.0, 12345.0}) {
    const auto ticks = round_ticks(largest);
    EXPECT_GE(ticks.back(), largest);
    EXPECT_GE(ticks.size(), 3u) << largest;
    EXPECT_LE(ticks.size(), 9u) << largest;
  }
}

}  // namespace
}  // namespace dapple::scaling
