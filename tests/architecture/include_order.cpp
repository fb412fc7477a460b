#include "tests/architecture/include_order.h"

#include <algorithm>
#include <optional>
#include <regex>

namespace dapple::architecture {
namespace {

struct Include {
  std::string name;
  bool quoted = false;
};

std::vector<Include> includes_of(const std::string& text) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const std::string& line : lines_of(text)) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) includes.push_back({match[2], match[1] == "\""});
  }
  return includes;
}

std::optional<std::size_t> layer_of(const std::string& module) {
  const auto& layers = module_layers();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (std::ranges::find(layers[i], module) != layers[i].end()) return i;
  }
  return std::nullopt;
}

bool is_standard_header(const std::string& name) { return name.find('/') == std::string::npos; }

// The reason why a file of module `from` may not include `name`, or nothing.
std::string objection_to_module_include(const SourceTree& tree, const std::string& from,
                                        const Include& include) {
  const auto parts = path_parts(include.name);
  if (!include.quoted) {
    return parts[0] == "dapple" && from != "capi" ? "includes an installed header" : "";
  }
  if (parts[0] == "dapple") return from == "capi" ? "" : "includes an installed header";
  if (!tree.contains("src/" + include.name)) return "is no file of src/; others stand in <>";
  if (parts[0] == from) return "";
  const auto to_layer = layer_of(parts[0]);
  const auto from_layer = layer_of(from);
  if (!to_layer || !from_layer) return "";  // the unknown module is reported on its own
  return *to_layer < *from_layer ? "" : "is not in a lower layer";
}

std::string objection_to_program_include(const SourceTree& tree, const std::string& file,
                                         const Include& include) {
  if (!include.quoted || include.name.starts_with("dapple/")) return "";
  const std::string folder = file.substr(0, file.rfind('/') + 1);
  const bool known = tree.contains("src/" + include.name) ||
                     tree.contains("apps/" + include.name) || tree.contains(folder + include.name);
  return known ? "" : "is in neither src/ nor apps/";
}

std::string objection_to_public_include(const SourceTree& tree, const Include& include) {
  if (tree.contains("include/" + include.name)) return "";
  return !include.quoted && is_standard_header(include.name)
             ? ""
             : "is neither an installed header nor one of the language";
}

std::string objection(const SourceTree& tree, const std::string& file, const Include& include) {
  const auto parts = path_parts(file);
  if (parts[0] == "src") return objection_to_module_include(tree, parts[1], include);
  if (parts[0] == "apps") return objection_to_program_include(tree, file, include);
  if (parts[0] == "include") return objection_to_public_include(tree, include);
  return "";
}

}  // namespace

const std::vector<std::vector<std::string>>& module_layers() {
  static const std::vector<std::vector<std::string>> layers = {
      {"util"},     {"math"},
      {"parallel"}, {"image"},
      {"scene"},    {"scene_file", "import", "accel", "shading"},
      {"render"},   {"cluster", "view", "capi"},
  };
  return layers;
}

std::vector<std::string> include_violations(const SourceTree& tree) {
  std::vector<std::string> violations;
  for (const auto& [file, text] : tree) {
    const auto parts = path_parts(file);
    if (parts[0] == "src" && (parts.size() < 3 || !layer_of(parts[1]))) {
      violations.push_back(file + ": is in no known module");
      continue;
    }
    for (const Include& include : includes_of(text)) {
      const std::string reason = objection(tree, file, include);
      if (!reason.empty()) violations.push_back(file + ": " + include.name + " " + reason);
    }
  }
  return violations;
}

}  // namespace dapple::architecture
