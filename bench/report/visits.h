// How much memory a ray reads, with the tree and without.
#pragma once

#include <string>

#include "util/error.h"

namespace dapple::bench {

// visits.csv: for each scene the nodes, leaves and bytes that a ray of a whole picture reads when
// it is traced alone, nearest child first, and how much of the structures a picture reads at all.
[[nodiscard]] Status study_visits(const std::string& folder);

}  // namespace dapple::bench
