#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "dapple/scaling/charts.h"
#include "dapple/scaling/csv.h"
#include "dapple/scaling/json.h"
#include "dapple/scaling/report_text.h"
#include "tests/scaling/made_up_runs.h"
#include "tests/scaling/well_formed.h"

namespace dapple::scaling {
namespace {

using Rows = std::vector<std::vector<std::string>>;

Result made_up_result() {
  Result result;
  result.base = {"nice", 10, 20, 1, 2, 3};
  result.machine = quiet_machine(2);
  result.measurements = made_up_runs({WorkKind::ray, WorkKind::build}, {1, 2, 4}, 5, 0.25);
  result.curves = make_curves(result.measurements, result.machine.cores);
  result.warnings = find_warnings(result.curves, result.measurements, result.machine, true);
  return result;
}

// The value of a column in the line that begins with those fields.
std::string field(const Rows& rows, const std::vector<std::string>& key,
                  const std::string& column) {
  const auto place = std::find(rows[0].begin(), rows[0].end(), column) - rows[0].begin();
  for (const auto& row : rows) {
    if (std::equal(key.begin(), key.end(), row.begin())) {
      return row.at(static_cast<std::size_t>(place));
    }
  }
  return "no such line";
}

TEST(Csv, EveryLineHasTheFieldsOfTheHeader) {
  const Result result = made_up_result();
  for (const std::string& text :
       {points_csv(result), fits_csv(result), threads_csv(result), machine_csv(result)}) {
    const Rows rows = read_csv(text);
    ASSERT_GT(rows.size(), 1u);
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(std::set<std::string>(rows[0].begin(), rows[0].end()).size(), rows[0].size());
  }
}

TEST(Csv, HoldsWhatWasMeasured) {
  const Result result = made_up_result();
  const Rows points = read_csv(points_csv(result));
  EXPECT_EQ(points.size(), 1u + 2 * 2 * 3);
  EXPECT_EQ(field(points, {"ray", "strong", "2"}, "speedup"), "1.6");  // 1 / (0.25 + 0.75 / 2)
  EXPECT_EQ(field(points, {"ray", "weak", "2"}, "speedup"), "1.75");   // 2 - 0.25
  EXPECT_EQ(field(points, {"build", "weak", "4"}, "oversubscribed"), "1");
  EXPECT_EQ(field(points, {"build", "weak", "2"}, "oversubscribed"), "0");
  EXPECT_EQ(field(points, {"build", "weak", "2"}, "noisy"), "0");
  const Rows fits = read_csv(fits_csv(result));
  EXPECT_EQ(field(fits, {"ray", "strong"}, "serial_fraction"), "0.25");
  EXPECT_EQ(field(fits, {"build", "weak"}, "grows"), "objects");
  const Rows machine = read_csv(machine_csv(result));
  EXPECT_EQ(field(machine, {"processor"}, "value"), "Imagined \"X\", 3 GHz");
  EXPECT_TRUE(field(machine, {"warning"}, "value").starts_with("4 threads on 2 cores"));
  // 5 rounds of 1, 2, 2, 4 and 4 threads for each of two works.
  EXPECT_EQ(read_csv(threads_csv(result)).size(), 1u + 5 * 13 * 2);
}

TEST(Json, SaysTheSame) {
  const Result result = made_up_result();
  const auto json = nlohmann::json::parse(to_json_text(result));
  EXPECT_EQ(json["machine"]["cores"], 2);
  EXPECT_EQ(json["warnings"].size(), 1u);
  ASSERT_EQ(json["curves"].size(), 4u);
  EXPECT_EQ(json["curves"][0]["work"], "ray");
  EXPECT_EQ(json["curves"][0]["law"], "Amdahl");
  EXPECT_NEAR(json["curves"][0]["serial_fraction"]["value"].get<double>(), 0.25, 1e-9);
  EXPECT_EQ(json["curves"][1]["grows"], "samples");
  EXPECT_EQ(json["curves"][3]["points"][2]["oversubscribed"], true);
  EXPECT_EQ(json["measurements"].size(), result.measurements.plan.size());
  EXPECT_EQ(json["measurements"][1]["runs"].size(), 5u);
}

TEST(Json, AMissingFitIsNull) {
  Result result = made_up_result();
  result.curves[0].serial_fraction.reset();
  EXPECT_TRUE(
      nlohmann::json::parse(to_json_text(result))["curves"][0]["serial_fraction"].is_null());
  EXPECT_EQ(read_csv(fits_csv(result)).size(), 4u);
}

TEST(Charts, AreWellFormedAndSayWhatIsDoubtful) {
  const Result result = made_up_result();
  std::set<std::string> names;
  for (const Chart& chart : make_charts(result)) {
    EXPECT_TRUE(names.insert(chart.file).second);
    EXPECT_EQ(xml_problem(chart.svg), "") << chart.file;
    EXPECT_NE(chart.svg.find(">ideal</text>"), std::string::npos);
    EXPECT_NE(chart.svg.find("Warning: 4 threads on 2 cores"), std::string::npos);
  }
  for (const char* name :
       {"strong-time.svg", "strong-speedup.svg", "strong-efficiency.svg", "weak-time.svg",
        "weak-speedup.svg", "weak-efficiency.svg", "strong-imbalance.svg", "weak-imbalance.svg"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(Text, NamesEveryCurveAndFit) {
  const std::string text = to_text(made_up_result());
  for (const char* part : {"ray, strong scaling: nice, 10 x 20 pixels, 1 samples\n",
                           "build, weak scaling: spheres:3; objects grow with the threads\n",
                           "Amdahl's law: serial fraction 25.00 %",
                           "Gustafson's law: serial fraction 25.00 %", "more than cores"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  }
}

}  // namespace
}  // namespace dapple::scaling
