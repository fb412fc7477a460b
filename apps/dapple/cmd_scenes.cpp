#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/standard_output.h"
#include "dapple/commands.h"
#include "scene/named_scenes.h"

namespace dapple {
namespace {

std::string as_text() {
  std::string text;
  for (const NamedScene& scene : named_scenes()) {
    const std::string name =
        scene.size_meaning.empty() ? std::string(scene.name) : fmt::format("{}[:N]", scene.name);
    text += fmt::format("{:<14}{}\n", name, scene.summary);
  }
  return text;
}

std::string as_json() {
  auto list = nlohmann::ordered_json::array();
  for (const NamedScene& scene : named_scenes()) {
    nlohmann::ordered_json entry{{"name", scene.name}, {"summary", scene.summary}};
    if (!scene.size_meaning.empty()) entry["size"] = scene.size_meaning;
    list.push_back(std::move(entry));
  }
  return list.dump(2) + "\n";
}

}  // namespace

Expected<int> run_scenes(const Arguments& arguments) {
  return print_output(arguments.given("json") ? as_json() : as_text()).map([] { return 0; });
}

}  // namespace dapple
