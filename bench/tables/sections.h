// Results as Markdown.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace dapple::bench {

// Name of a section of the document, and its text.
using Sections = std::map<std::string, std::string>;

// `result` is what one benchmark program wrote with --json; throws nlohmann::json::exception when
// it is something else.
void add_sections(const nlohmann::json& result, Sections& sections);

}  // namespace dapple::bench
