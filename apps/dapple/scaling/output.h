// The files that a study leaves behind.
#pragma once

#include <string>

#include "dapple/scaling/result.h"

namespace dapple::scaling {

// Makes the folder if there is none. Better known before the study than after it.
[[nodiscard]] Status prepare_folder(const std::string& folder);

// points.csv, fits.csv, threads.csv, machine.csv, scaling.json and the plots.
[[nodiscard]] Status write_files(const Result& result, const std::string& folder);

}  // namespace dapple::scaling
