#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "import/gltf/check.h"
#include "import/gltf/schema.h"

namespace dapple::gltf {
namespace {

bool is_kind(const JsonValue& value, JsonKind kind) {
  switch (kind) {
    case JsonKind::boolean:
      return value.is_bool();
    case JsonKind::integer:
      return value.is_number() && value.number_or(0) == std::floor(value.number_or(0));
    case JsonKind::number:
      return value.is_number();
    case JsonKind::text:
      return value.is_text();
    case JsonKind::object:
      return value.is_object();
  }
  return false;
}

std::string_view kind_name(JsonKind kind) {
  constexpr std::string_view kNames[] = {"true or false", "an integer", "a number", "a string",
                                         "an object"};
  return kNames[static_cast<std::size_t>(kind)];
}

class Checker {
 public:
  explicit Checker(const Context& context) : context_(context), root_(context.document.root()) {}

  Status check_object(const JsonValue& value, const Schema& schema, const std::string& pointer) {
    for (const Property& property : schema.properties) {
      const JsonValue& member = value[property.name];
      const std::string place = pointer + "/" + std::string(property.name);
      if (member.is_null()) {
        if (property.required) return error(place, "is missing");
      } else if (auto ok = check_member(member, property, place); !ok) {
        return ok;
      }
    }
    return check_extensions(value["extensions"], schema.location, pointer + "/extensions");
  }

  Status check_declarations() {
    std::set<std::string> used;
    for (const JsonValue& name : root_["extensionsUsed"].items()) {
      if (!used.insert(name.text()).second)
        warn("/extensionsUsed", "names " + name.text() + " twice");
      if (!is_known_extension(name.text())) {
        warn("/extensionsUsed", name.text() + " is not supported and is ignored");
      }
    }
    for (const JsonValue& name : root_["extensionsRequired"].items()) {
      if (!is_known_extension(name.text())) {
        return error("/extensionsRequired", name.text() + " is required but not supported");
      }
      if (!used.contains(name.text())) {
        warn("/extensionsRequired", name.text() + " is not in extensionsUsed");
      }
    }
    for (const std::string& name : met_) {
      if (!used.contains(name)) warn("/extensionsUsed", name + " is used but not declared");
    }
    return {};
  }

  Status check_version() {
    const auto major = [](const std::string& version) {
      return version.substr(0, version.find('.'));
    };
    const auto is_version = [](const std::string& v) {
      const std::size_t dot = v.find('.');
      return dot != 0 && dot != std::string::npos && dot + 1 < v.size() &&
             v.find_first_not_of("0123456789", 0) == dot &&
             v.find_first_not_of("0123456789", dot + 1) == std::string::npos;
    };
    for (const char* key : {"version", "minVersion"}) {
      const JsonValue& version = root_["asset"][key];
      if (version.is_null()) continue;
      const std::string place = std::string("/asset/") + key;
      if (!is_version(version.text())) return error(place, "is not of the form 2.0");
      if (major(version.text()) != "2" || (key[0] == 'm' && version.text() > "2.0")) {
        return error(place, "version " + version.text() + " of glTF is not supported");
      }
    }
    return {};
  }

 private:
  [[nodiscard]] tl::unexpected<Error> error(const std::string& pointer, std::string message) const {
    return context_.document.error(pointer, std::move(message));
  }
  void warn(const std::string& pointer, const std::string& message) const {
    context_.warn(pointer, message);
  }

  Status check_member(const JsonValue& member, const Property& property, const std::string& place) {
    if (!property.is_array) return check_value(member, property, place);
    if (!member.is_array()) return error(place, "is not an array");
    const std::size_t count = member.size();
    if (count == 0) warn(place, "is empty");
    const std::size_t least = property.least_items > 1 ? property.least_items : 0;
    if (count < least || count > property.most_items) {
      return error(place, fmt::format("has {} items", count));
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (auto ok = check_value(member[i], property, fmt::format("{}/{}", place, i)); !ok)
        return ok;
    }
    if (!property.refers.empty()) check_unique(member, place);
    return {};
  }

  void check_unique(const JsonValue& array, const std::string& place) const {
    std::set<double> seen;
    for (const JsonValue& item : array.items()) {
      if (!seen.insert(item.number_or(0)).second) warn(place, "has an item twice");
    }
  }

  Status check_value(const JsonValue& value, const Property& property, const std::string& place) {
    if (!is_kind(value, property.kind)) {
      return error(place, fmt::format("is not {}", kind_name(property.kind)));
    }
    if (property.object != nullptr) return check_object(value, *property.object, place);
    if (property.kind == JsonKind::object && value.size() == 0) warn(place, "is empty");
    if (!property.choices.empty()) return check_choice(value, property, place);
    if (!property.refers.empty()) {
      const auto index = value.index();
      if (index && *index < root_[property.refers].size()) return {};
      return error(place, fmt::format("{} is beyond the {} {}", value.number_or(0),
                                      root_[property.refers].size(), property.refers));
    }
    return check_range(value, property, place);
  }

  Status check_choice(const JsonValue& value, const Property& property, const std::string& place) {
    const std::string text = value.is_text() ? value.text() : fmt::format("{}", value.number_or(0));
    if (property.choices.find("|" + text + "|") != std::string_view::npos) return {};
    std::string choices(property.choices.substr(1, property.choices.size() - 2));
    std::replace(choices.begin(), choices.end(), '|', ' ');
    return error(place, fmt::format("{} is none of: {}", text, choices));
  }

  Status check_range(const JsonValue& value, const Property& property, const std::string& place) {
    if (!value.is_number()) return {};
    const double x = value.number_or(0);
    const bool low = property.above_low ? x <= property.low : x < property.low;
    if (low || x > property.high) return error(place, fmt::format("{} is out of range", x));
    return {};
  }

  Status check_extensions(const JsonValue& extensions, std::string_view location,
                          const std::string& pointer) {
    if (!extensions.is_null() && !extensions.is_object()) return error(pointer, "is not an object");
    for (const JsonMember& member : extensions.members()) {
      met_.insert(member.key);
      if (!is_known_extension(member.key)) continue;
      const std::string place = pointer + "/" + member.key;
      const Schema* schema = extension_schema(member.key, location);
      if (schema == nullptr) {
        warn(place, "the extension has no meaning here and is ignored");
      } else if (!member.value.is_object()) {
        return error(place, "is not an object");
      } else if (auto ok = check_object(member.value, *schema, place); !ok) {
        return ok;
      }
    }
    return {};
  }

  const Context& context_;
  const JsonValue& root_;
  std::set<std::string> met_;  // extensions
};

}  // namespace

Status check_structure(const Context& context) {
  if (!context.document.root().is_object()) {
    return context.document.error("", "its JSON is not an object");
  }
  if (context.document.has_mark()) context.warn("", "its JSON begins with a byte order mark");
  Checker checker(context);
  return checker.check_version()
      .and_then([&] { return checker.check_object(context.document.root(), kRootSchema, ""); })
      .and_then([&] { return checker.check_declarations(); });
}

}  // namespace dapple::gltf
