#include "scene/named_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/generators.h"
#include "util/parse_number.h"

namespace dapple {
namespace {

struct Generator {
  NamedScene scene;
  Scene (*make)(std::int64_t size);
  std::int64_t default_size;
  std::int64_t max_size;
};

// Sizes are limited so that primitive ids stay below 2^31.
const std::vector<Generator>& generators() {
  static const std::vector<Generator> table = {
      {{"empty", "no objects, only the sky", ""}, make_empty, 0, 0},
      {{"irreg", "a grid of mirror spheres (N x N, default 50)", "spheres a side"},
       make_irreg,
       50,
       40'000},
      {{"nice", "one sphere between three coloured metal walls", ""}, make_nice, 0, 0},
      {{"rgbbox", "an open box of spheres (four walls of N x N, default 10)", "spheres a side"},
       make_rgbbox,
       10,
       20'000},
      {{"spheres", "a random cloud of N spheres (default 10000)", "spheres"},
       make_sphere_cloud,
       10'000,
       1'600'000'000},
  };
  return table;
}

const Generator* find(std::string_view name) {
  const auto& table = generators();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Generator& g) { return g.scene.name == name; });
  return found == table.end() ? nullptr : &*found;
}

std::string_view name_part(std::string_view text) { return text.substr(0, text.find(':')); }

tl::unexpected<Error> unknown_scene(std::string_view text) {
  std::vector<std::string_view> names;
  for (const NamedScene& scene : named_scenes()) names.push_back(scene.name);
  return fail(
      Errc::no_input, std::string(text),
      fmt::format("no such file and no such scene; the scenes are {}", fmt::join(names, ", ")));
}

}  // namespace

const std::vector<NamedScene>& named_scenes() {
  static const std::vector<NamedScene> scenes = [] {
    std::vector<NamedScene> result;
    for (const Generator& generator : generators()) result.push_back(generator.scene);
    return result;
  }();
  return scenes;
}

bool is_scene_name(std::string_view text) { return find(name_part(text)) != nullptr; }

Expected<Scene> make_named_scene(std::string_view text) {
  const std::string_view name = name_part(text);
  const Generator* generator = find(name);
  if (generator == nullptr) return unknown_scene(text);
  if (name == text) return generator->make(generator->default_size);
  if (generator->max_size == 0) {
    return fail(Errc::usage, std::string(text), fmt::format("scene '{}' has one size only", name));
  }
  const auto size = parse_integer(text.substr(name.size() + 1), text, 1, generator->max_size);
  if (!size) return tl::unexpected(size.error());
  return generator->make(*size);
}

}  // namespace dapple
