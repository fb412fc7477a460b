#include "tables/sections.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/table.h"

namespace dapple::bench {
namespace {

using nlohmann::json;

std::string text(const json& row, const char* key) { return row.at(key).get<std::string>(); }
double number(const json& row, const char* key) { return row.at(key).get<double>(); }

std::string ratio_text(const json& ratio) {
  return fmt::format("{:.2f} ({:.2f}-{:.2f})", number(ratio, "median"), number(ratio, "low"),
                     number(ratio, "high"));
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

// Every row of one kind as a row of cells.
template <class CellsOf>
std::string table_of(const json& rows, std::vector<std::string> header, const CellsOf& cells_of) {
  Table table(std::move(header));
  for (const json& row : rows) table.add_row(cells_of(row));
  return table.markdown();
}

std::string machine_text(const json& result) {
  const json& m = result.at("machine");
  std::string lines = fmt::format(
      "{}, {} cores{}, {:.0f} GiB, {}, {}, `{}`; vector instructions {}; load average at the start "
      "{:.1f}.\n",
      text(m, "processor"), m.at("cores").get<int>(),
      m.at("virtual_machine").get<bool>() ? " of a virtual machine" : "", number(m, "memory_gib"),
      text(m, "system"), text(m, "compiler"), text(m, "flags"), text(m, "vector_instructions"),
      number(m, "load_at_start"));
  const std::size_t warnings = result.at("warnings").size();
  if (warnings > 0) {
    lines += fmt::format("{} measurements were noisier than they should be (see the spreads).\n",
                         warnings);
  }
  return lines;
}

// ---- bench_kernels ----

double rate_of(const json& row, const std::string& way) {
  for (const json& w : row.at("ways")) {
    if (text(w, "name") == way) return number(w, "million_per_second");
  }
  return 0;
}

std::string tracing_table(const json& rows) {
  return table_of(
      rows, {"scene", "rays", "cores", "dapple", "Embree 1", "Embree's best", "its mode", "ratio"},
      [](const json& row) -> std::vector<std::string> {
        const bool compared = row.contains("best_other");
        const std::string best = compared ? text(row, "best_other") : "";
        return {text(row, "scene"),
                text(row, "rays"),
                text(row, "cores"),
                fmt::format("{:.2f}", rate_of(row, "dapple")),
                compared ? fmt::format("{:.2f}", rate_of(row, "Embree 1")) : "-",
                compared ? fmt::format("{:.2f}", rate_of(row, best)) : "-",
                best,
                compared ? ratio_text(row.at("ratio")) : "-"};
      });
}

std::string build_table(const json& rows) {
  return table_of(rows,
                  {"scene", "structure", "cores", "seconds", "bytes/object", "SAH cost", "spread"},
                  [](const json& row) -> std::vector<std::string> {
                    const double sah = number(row, "sah_cost");
                    return {text(row, "scene"),
                            text(row, "name"),
                            text(row, "cores"),
                            fmt::format("{:.4f}", number(row, "median_s")),
                            fmt::format("{:.1f}", number(row, "bytes_per_object")),
                            sah > 0 ? fmt::format("{:.2f}", sah) : "-",
                            percent(number(row, "spread"))};
                  });
}

// The way that disagrees most stands for all ways of the same scene and rays.
std::string hits_table(const json& rows) {
  std::vector<json> worst;
  for (const json& row : rows) {
    const bool same_set = !worst.empty() && worst.back().at("scene") == row.at("scene") &&
                          worst.back().at("rays") == row.at("rays");
    if (!same_set) {
      worst.push_back(row);
    } else if (row.at("same") < worst.back().at("same")) {
      worst.back() = row;
    }
  }
  return table_of(worst, {"scene", "rays", "same", "borderline", "dapple wrong", "Embree wrong"},
                  [](const json& row) -> std::vector<std::string> {
                    return {text(row, "scene"),         text(row, "rays"),
                            row.at("same").dump(),      row.at("borderline").dump(),
                            row.at("own_wrong").dump(), row.at("other_wrong").dump()};
                  });
}

// ---- bench_render ----

std::string render_table(const json& rows) {
  return table_of(rows, {"scene", "renderer", "cores", "million rays/s", "seconds", "spread"},
                  [](const json& row) -> std::vector<std::string> {
                    return {text(row, "scene"),
                            text(row, "name"),
                            text(row, "cores"),
                            fmt::format("{:.2f}", number(row, "million_per_second")),
                            fmt::format("{:.3f}", number(row, "median_s")),
                            percent(number(row, "spread"))};
                  });
}

std::string efficiency_text(const json& efficiency) {
  return fmt::format("{:.3f} ({:.3f})", number(efficiency, "wall"), number(efficiency, "cpu"));
}

std::string ratios_table(const json& results) {
  Table table({"what", "dapple / textbook, one core", "all cores",
               "parallel efficiency (by processor time)"});
  for (const json& row : results.at("render_ratios")) {
    table.add_row({"rendering " + text(row, "scene"), ratio_text(row.at("one_core")),
                   ratio_text(row.at("all_cores")), efficiency_text(row.at("efficiency"))});
  }
  if (results.contains("build_ratios")) {
    for (const json& row : results.at("build_ratios")) {
      table.add_row({"building " + text(row, "scene"), ratio_text(row.at("textbook")), "-",
                     efficiency_text(row.at("efficiency"))});
    }
  }
  return table.markdown();
}

// ---- bench_scene_file ----

std::string steps_table(const json& results) {
  std::string result;
  for (const json& file : results.at("files")) {
    result +=
        fmt::format("- {} {}: {} bytes, {:.3f} times the arrays in memory\n", text(file, "scene"),
                    text(file, "file"), file.at("bytes").dump(), number(file, "of_raw_arrays"));
  }
  return result + "\n" +
         table_of(results.at("steps"),
                  {"scene", "file", "step", "seconds", "GB/s", "of page cache read"},
                  [](const json& row) -> std::vector<std::string> {
                    return {text(row, "scene"),
                            text(row, "file"),
                            text(row, "name"),
                            fmt::format("{:.4f}", number(row, "median_s")),
                            fmt::format("{:.2f}", number(row, "gb_per_second")),
                            fmt::format("{:.2f}", number(row, "of_page_cache_read"))};
                  });
}

}  // namespace

void add_sections(const json& result, Sections& sections) {
  const std::string bench = text(result, "bench");
  const json& results = result.at("results");
  sections[bench + " machine"] = machine_text(result);
  if (bench == "kernels") {
    sections["kernels tracing"] = tracing_table(results.at("tracing"));
    sections["kernels build"] = build_table(results.at("build"));
    if (results.contains("hits")) sections["kernels hits"] = hits_table(results.at("hits"));
  } else if (bench == "render") {
    sections["render ratios"] = ratios_table(results);
    sections["render rates"] = render_table(results.at("render"));
  } else if (bench == "scene_file") {
    sections["scene_file steps"] = steps_table(results);
  }
}

}  // namespace dapple::bench
