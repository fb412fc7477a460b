#include "dapple/scaling/output.h"

#include <filesystem>
#include <span>

#include "common/program.h"
#include "dapple/scaling/charts.h"
#include "dapple/scaling/csv.h"
#include "dapple/scaling/json.h"
#include "util/atomic_file.h"

namespace dapple::scaling {

Status prepare_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(Errc::cannot_create, folder, "cannot be created: " + error.message());
  return check_output((std::filesystem::path(folder) / "scaling.json").string());
}

Status write_files(const Result& result, const std::string& folder) {
  std::vector<Chart> files = make_charts(result);
  files.push_back({"points.csv", points_csv(result)});
  files.push_back({"fits.csv", fits_csv(result)});
  files.push_back({"threads.csv", threads_csv(result)});
  files.push_back({"machine.csv", machine_csv(result)});
  files.push_back({"scaling.json", to_json_text(result)});
  for (const auto& [name, text] : files) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    if (auto status = write_file_atomically(path, std::as_bytes(std::span(text))); !status) {
      return status;
    }
  }
  return {};
}

}  // namespace dapple::scaling
