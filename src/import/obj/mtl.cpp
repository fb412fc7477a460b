#include "import/obj/mtl.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/text.h"

namespace dapple::obj {
namespace {

struct ColourKey {
  std::string_view keyword;
  Vec3f MtlMaterial::*member;
};
constexpr ColourKey kColours[] = {
    {"kd", &MtlMaterial::kd}, {"ks", &MtlMaterial::ks}, {"ke", &MtlMaterial::ke}};

struct NumberKey {
  std::string_view keyword;
  float MtlMaterial::*member;
};
constexpr NumberKey kNumbers[] = {
    {"ni", &MtlMaterial::ni},
    {"d", &MtlMaterial::d},
    {"ps", &MtlMaterial::sheen},
    {"pc", &MtlMaterial::clearcoat},
    {"pcr", &MtlMaterial::clearcoat_roughness},
    {"aniso", &MtlMaterial::anisotropy},
    {"anisor", &MtlMaterial::anisotropy_rotation},
};

struct MapKey {
  std::string_view keyword;
  MtlMapUse use;
};
constexpr MapKey kMaps[] = {
    {"map_kd", MtlMapUse::kd},        {"map_ks", MtlMapUse::ks},
    {"map_ke", MtlMapUse::ke},        {"map_emissive", MtlMapUse::ke},
    {"map_d", MtlMapUse::d},          {"map_opacity", MtlMapUse::d},
    {"map_bump", MtlMapUse::bump},    {"bump", MtlMapUse::bump},
    {"norm", MtlMapUse::normal},      {"map_kn", MtlMapUse::normal},
    {"map_pr", MtlMapUse::roughness}, {"map_pm", MtlMapUse::metallic},
    {"map_ps", MtlMapUse::sheen},
};

// What carries no meaning for a path tracer.
constexpr std::string_view kUnused[] = {"ka",      "map_ka", "tf",    "map_ns", "sharpness",
                                        "map_aat", "refl",   "disp",  "decal",  "kt",
                                        "km",      "tr",     "illum", "map_tr", "map_disp"};

// How many words follow an option of a map: from the first number to the second.
struct OptionWords {
  std::string_view option;
  int least, most;
};
constexpr OptionWords kOptions[] = {
    {"-blendu", 1, 1},  {"-blendv", 1, 1}, {"-boost", 1, 1},  {"-mm", 2, 2},        {"-o", 1, 3},
    {"-s", 1, 3},       {"-t", 1, 3},      {"-texres", 1, 1}, {"-clamp", 1, 1},     {"-bm", 1, 1},
    {"-imfchan", 1, 1}, {"-type", 1, 1},   {"-cc", 1, 1},     {"-colorspace", 1, 1}};

const OptionWords* option_of(std::string_view word) {
  for (const OptionWords& option : kOptions) {
    if (option.option == word) return &option;
  }
  return nullptr;
}

// "[options] file name [options]"; the name may hold blanks.
MtlMap parse_map(std::string_view rest, std::size_t line) {
  MtlMap map;
  map.line = line;
  WordReader words(rest);
  std::string_view word = words.next();
  while (!word.empty()) {
    const OptionWords* option = option_of(word);
    if (option == nullptr) {
      if (!map.file.empty()) map.file += ' ';
      map.file += word;
      word = words.next();
      continue;
    }
    std::vector<float> values;
    std::string_view argument;
    int taken = 0;
    for (word = words.next(); !word.empty() && taken < option->most; word = words.next()) {
      const auto value = to_number(word);
      if (taken >= option->least && !value) break;
      values.push_back(value ? to_float(*value) : 0.0f);
      argument = word;
      ++taken;
    }
    if (taken == 0) break;
    if (option->option == "-o") map.offset = {values[0], taken > 1 ? values[1] : 0.0f};
    if (option->option == "-s") map.scale = {values[0], taken > 1 ? values[1] : 1.0f};
    if (option->option == "-bm") map.strength = values[0];
    if (option->option == "-clamp") map.clamp = argument == "on";
  }
  std::ranges::replace(map.file, '\\', '/');
  return map;
}

class MtlParser {
 public:
  MtlParser(std::string_view text, std::string_view name, MtlLibrary& library)
      : lines_(text), name_(name), library_(library) {}

  Status parse() {
    std::string_view line;
    while (lines_.next(line)) {
      WordReader words(line);
      const std::string keyword = in_lower_case(words.next());
      if (keyword.empty() || keyword.starts_with('#')) continue;
      if (keyword == "newmtl") {
        begin(words.rest());
      } else if (material_ == nullptr) {
        return bad("a statement stands before the first 'newmtl'");
      } else if (auto status = statement(keyword, words); !status) {
        return status;
      }
    }
    return {};
  }

 private:
  tl::unexpected<Error> bad(std::string message) const {
    return fail(Errc::bad_data, line_place(name_, lines_.number()), std::move(message));
  }
  void warn(std::string_view message) {
    library_.warnings.push_back(fmt::format("{}: {}", line_place(name_, lines_.number()), message));
  }

  void begin(std::string_view name) {
    material_ = &library_.materials[std::string(name)];
    *material_ = {};
    material_->name = name;
  }

  Status statement(const std::string& keyword, WordReader& words) {
    for (const ColourKey& key : kColours) {
      if (key.keyword == keyword) return colour(words, material_->*key.member);
    }
    for (const NumberKey& key : kNumbers) {
      if (key.keyword == keyword) return number(keyword, words, material_->*key.member);
    }
    for (const MapKey& key : kMaps) {
      if (key.keyword != keyword) continue;
      material_->map(key.use) = parse_map(words.rest(), lines_.number());
      if (material_->map(key.use).file.empty()) return bad("a map needs the name of a file");
      return {};
    }
    return other(keyword, words);
  }

  Status other(const std::string& keyword, WordReader& words) {
    float value = 0;
    if (keyword == "ns" || keyword == "pr" || keyword == "pm" || keyword == "tr" ||
        keyword == "illum") {
      if (auto status = number(keyword, words, value); !status) return status;
    }
    if (keyword == "ns") material_->ns = value;
    if (keyword == "pr") material_->roughness = value;
    if (keyword == "pm") material_->metallic = value;
    if (keyword == "tr") material_->d = 1 - value;
    if (keyword == "illum" && value >= 0 && value <= 10) material_->illum = static_cast<int>(value);
    const bool known = keyword == "ns" || keyword == "pr" || keyword == "pm" ||
                       std::ranges::find(kUnused, keyword) != std::end(kUnused);
    if (!known) warn(fmt::format("'{:.40}' is not understood", keyword));
    return {};
  }

  Status number(const std::string& keyword, WordReader& words, float& result) {
    std::string_view word = words.next();
    if (keyword == "d" && word == "-halo") word = words.next();
    const auto value = to_number(word);
    if (!value || !std::isfinite(to_float(*value))) {
      return bad(fmt::format("'{:.40}' is not a finite number", word));
    }
    result = to_float(*value);
    return {};
  }

  Status colour(WordReader& words, Vec3f& result) {
    float values[3] = {};
    int count = 0;
    for (std::string_view word = words.next(); !word.empty() && count < 3; word = words.next()) {
      if (word == "spectral" || word == "xyz") {
        warn(fmt::format("colours given as '{}' are not understood", word));
        return {};
      }
      if (word.starts_with('#')) break;
      const auto value = to_number(word);
      if (!value || !std::isfinite(to_float(*value))) {
        return bad(fmt::format("'{:.40}' is not a finite number", word));
      }
      values[count++] = to_float(*value);
    }
    if (count == 0) return bad("a colour needs a number");
    result = count == 3 ? Vec3f(values[0], values[1], values[2])
                        : Vec3f(values[0], values[0], values[0]);
    return {};
  }

  LineReader lines_;
  std::string_view name_;
  MtlLibrary& library_;
  MtlMaterial* material_ = nullptr;
};

}  // namespace

Status read_mtl(std::string_view text, std::string_view name, MtlLibrary& library) {
  return MtlParser(text, name, library).parse();
}

}  // namespace dapple::obj
