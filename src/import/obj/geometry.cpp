#include "import/obj/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "import/limits.h"
#include "import/text.h"

namespace dapple::obj {
namespace {

// Positive indices may name what the file defines later, so they are checked at its end.
struct Reference {
  std::uint32_t highest = 0;  // index + 1
  std::size_t line = 0;
};

class GeometryParser {
 public:
  GeometryParser(std::string_view text, std::string_view name, bool keep_going)
      : lines_(text), name_(name), keep_going_(keep_going) {}

  Expected<Geometry> parse() {
    std::string_view line;
    while (next_logical_line(line)) {
      if (auto status = statement(line); !status) return tl::unexpected(status.error());
    }
    if (auto status = resolve(); !status) return tl::unexpected(status.error());
    return std::move(geometry_);
  }

 private:
  tl::unexpected<Error> bad(std::string message) const { return bad(line_, std::move(message)); }
  tl::unexpected<Error> bad(std::size_t line, std::string message) const {
    return fail(Errc::bad_data, line_place(name_, line), std::move(message));
  }

  // A line that ends in a backslash goes on in the next one.
  bool next_logical_line(std::string_view& line) {
    if (!lines_.next(line)) return false;
    line_ = lines_.number();
    if (!trimmed(line).ends_with('\\')) return true;
    joined_.clear();
    do {
      line = trimmed(line);
      if (!line.ends_with('\\')) break;
      line.remove_suffix(1);
      joined_ += line;
      joined_ += ' ';
      line = {};
    } while (lines_.next(line));
    joined_ += line;
    line = joined_;
    return true;
  }

  Status statement(std::string_view line) {
    WordReader words(line);
    const std::string_view keyword = words.next();
    if (keyword.empty() || keyword.starts_with('#')) return {};
    if (keyword == "v") return position(words);
    if (keyword == "vn") return normal(words);
    if (keyword == "vt") return uv(words);
    if (keyword == "f" || keyword == "fo") return element(ElementKind::face, words);
    if (keyword == "l") return element(ElementKind::line, words);
    if (keyword == "p") return element(ElementKind::points, words);
    if (keyword == "s") return smoothing(words);
    if (keyword == "usemtl") {
      material_ = material_index(words.rest());
    } else if (keyword == "mtllib") {
      geometry_.libraries.push_back({std::string(words.rest()), line_});
    } else if (keyword != "g" && keyword != "o") {
      ignore(keyword);
    }
    return {};
  }

  void ignore(std::string_view keyword) {
    if (ignored_.size() < kMaxWarnings && ignored_.insert(std::string(keyword)).second) {
      geometry_.warnings.push_back(
          fmt::format("{}: '{:.40}' is not understood", line_place(name_, line_), keyword));
    }
  }

  // Up to eight numbers; what follows a '#' is a comment.
  Expected<std::size_t> numbers(WordReader& words) {
    std::size_t count = 0;
    for (std::string_view word = words.next(); !word.empty() && !word.starts_with('#');
         word = words.next()) {
      const auto value = to_number(word);
      // "1.#IND" and the like are how some programs write what is not finite.
      if (!value && word.find('#') == word.npos) {
        return bad(fmt::format("'{:.40}' is not a number", word));
      }
      if (count < numbers_.size()) {
        numbers_[count++] = value ? to_float(*value) : std::numeric_limits<float>::quiet_NaN();
      }
    }
    return count;
  }

  Status position(WordReader& words) {
    const auto count = numbers(words);
    if (!count) return tl::unexpected(count.error());
    if (*count < 3) return bad("a vertex needs three coordinates");
    geometry_.positions.emplace_back(numbers_[0], numbers_[1], numbers_[2]);
    auto& colours = geometry_.colours;
    if (*count >= 6) {
      const std::size_t at = *count == 7 ? 4 : 3;  // behind a weight
      colours.resize(geometry_.positions.size() - 1, Vec3f(1, 1, 1));
      colours.emplace_back(numbers_[at], numbers_[at + 1], numbers_[at + 2]);
    } else if (!colours.empty()) {
      colours.emplace_back(1.0f, 1.0f, 1.0f);
    }
    return {};
  }

  Status normal(WordReader& words) {
    const auto count = numbers(words);
    if (!count) return tl::unexpected(count.error());
    if (*count < 3) return bad("a normal needs three coordinates");
    const Vec3f n(numbers_[0], numbers_[1], numbers_[2]);
    const float size = length(n);
    geometry_.normals.push_back(size > 0 && std::isfinite(size) ? n / size : Vec3f());
    return {};
  }

  Status uv(WordReader& words) {
    const auto count = numbers(words);
    if (!count) return tl::unexpected(count.error());
    if (*count < 1) return bad("a texture coordinate needs a number");
    geometry_.uvs.push_back({numbers_[0], *count > 1 ? numbers_[1] : 0.0f});
    return {};
  }

  Status smoothing(WordReader& words) {
    const std::string_view word = words.next();
    if (word == "off") {
      smoothing_ = 0;
    } else if (const auto group = to_integer(word); group && *group >= 0 && *group < kNone) {
      smoothing_ = static_cast<std::uint32_t>(*group);
    } else {
      smoothing_ = word == "on" ? 1 : 0;
    }
    return {};
  }

  std::uint32_t material_index(std::string_view name) {
    const auto next = static_cast<std::uint32_t>(geometry_.materials.size());
    const auto [at, is_new] = material_of_name_.try_emplace(std::string(name), next);
    if (is_new) geometry_.materials.emplace_back(name);
    return at->second;
  }

  Status element(ElementKind kind, WordReader& words) {
    const std::size_t first = geometry_.corners.size();
    for (std::string_view word = words.next(); !word.empty() && !word.starts_with('#');
         word = words.next()) {
      const Status status = corner(word);
      if (status) continue;
      if (!keep_going_) return status;
      geometry_.corners.resize(first);
      note_broken(status.error());
      return {};
    }
    const std::size_t count = geometry_.corners.size() - first;
    const std::size_t least = kind == ElementKind::face ? 3 : kind == ElementKind::line ? 2 : 1;
    if (count < least) {
      geometry_.corners.resize(first);
      ++geometry_.small_faces;
      return {};
    }
    geometry_.elements.push_back({first, material_, smoothing_, kind});
    return {};
  }

  // "position", "position/uv", "position//normal" or "position/uv/normal".
  Status corner(std::string_view word) {
    Corner corner;
    const std::size_t slash = std::min(word.find('/'), word.size());
    std::string_view rest = word.substr(slash);
    auto status = index(word.substr(0, slash), geometry_.positions.size(), highest_position_,
                        "vertex", corner.position);
    if (!status) return status;
    if (!rest.empty()) rest.remove_prefix(1);
    const std::size_t second = std::min(rest.find('/'), rest.size());
    if (second > 0) {
      status = index(rest.substr(0, second), geometry_.uvs.size(), highest_uv_,
                     "texture coordinate", corner.uv);
      if (!status) return status;
    }
    rest.remove_prefix(std::min(second + 1, rest.size()));
    if (!rest.empty()) {
      status = index(rest, geometry_.normals.size(), highest_normal_, "normal", corner.normal);
      if (!status) return status;
    }
    geometry_.corners.push_back(corner);
    return {};
  }

  // From 1, or backwards from -1, the latest.
  Status index(std::string_view word, std::size_t defined, Reference& highest,
               std::string_view what, std::uint32_t& result) {
    const auto value = to_integer(word);
    if (!value) return bad(fmt::format("'{:.40}' is not the index of a {}", word, what));
    if (*value == 0) return bad(fmt::format("index 0 of a {}; they begin at 1", what));
    if (*value < 0 && static_cast<std::uint64_t>(-(*value + 1)) >= defined) {
      return bad(fmt::format("{} {} of {} that come before", what, *value, defined));
    }
    if (*value >= kNone) return bad(fmt::format("{} {} is too far", what, *value));
    result = static_cast<std::uint32_t>(*value < 0 ? static_cast<std::int64_t>(defined) + *value
                                                   : *value - 1);
    if (result >= highest.highest) highest = {result + 1, line_};
    return {};
  }

  // Some programs write the indices of normals or texture coordinates that they leave out.
  void drop_undefined(Reference& highest, bool defined, std::uint32_t Corner::*member,
                      std::string_view what) {
    if (highest.highest == 0 || defined) return;
    for (Corner& corner : geometry_.corners) corner.*member = kNone;
    geometry_.warnings.push_back(fmt::format("{}: the file defines no {}s; its indices are ignored",
                                             line_place(name_, highest.line), what));
    highest = {};
  }

  void note_broken(const Error& reason) {
    if (geometry_.broken_elements++ == 0) geometry_.broken_reason = to_string(reason);
  }

  static bool is_within(std::uint32_t index, std::size_t count) {
    return index == kNone || index < count;
  }
  bool is_whole(const Corner& corner) const {
    return corner.position < geometry_.positions.size() &&
           is_within(corner.uv, geometry_.uvs.size()) &&
           is_within(corner.normal, geometry_.normals.size());
  }

  // Only the elements all of whose indices name something stay.
  void leave_out_broken(const Error& reason) {
    const std::vector<Corner> corners = std::exchange(geometry_.corners, {});
    const std::vector<Element> elements = std::exchange(geometry_.elements, {});
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const std::size_t begin = elements[e].first_corner;
      const std::size_t end =
          e + 1 < elements.size() ? elements[e + 1].first_corner : corners.size();
      const auto of_element = std::span(corners).subspan(begin, end - begin);
      if (!std::all_of(of_element.begin(), of_element.end(),
                       [&](const Corner& c) { return is_whole(c); })) {
        note_broken(reason);
        continue;
      }
      geometry_.elements.push_back(elements[e]);
      geometry_.elements.back().first_corner = geometry_.corners.size();
      geometry_.corners.insert(geometry_.corners.end(), of_element.begin(), of_element.end());
    }
  }

  Status resolve() {
    const Status status = check_references();
    if (status || !keep_going_) return status;
    leave_out_broken(status.error());
    return {};
  }

  Status check_references() {
    drop_undefined(highest_uv_, !geometry_.uvs.empty(), &Corner::uv, "texture coordinate");
    drop_undefined(highest_normal_, !geometry_.normals.empty(), &Corner::normal, "normal");
    const auto check = [&](const Reference& reference, std::size_t count, std::string_view what) {
      return reference.highest <= count
                 ? Status()
                 : bad(reference.line, fmt::format("{} {} of {}", what, reference.highest, count));
    };
    if (auto s = check(highest_position_, geometry_.positions.size(), "vertex"); !s) return s;
    if (auto s = check(highest_uv_, geometry_.uvs.size(), "texture coordinate"); !s) return s;
    return check(highest_normal_, geometry_.normals.size(), "normal");
  }

  LineReader lines_;
  std::string_view name_;
  bool keep_going_;
  std::string joined_;
  std::size_t line_ = 0;
  Geometry geometry_;
  std::array<float, 8> numbers_{};
  std::map<std::string, std::uint32_t, std::less<>> material_of_name_;
  std::uint32_t material_ = kNone;
  std::uint32_t smoothing_ = 0;
  std::set<std::string> ignored_;
  Reference highest_position_, highest_uv_, highest_normal_;
};

}  // namespace

Expected<Geometry> read_geometry(std::string_view text, std::string_view name, bool keep_going) {
  return GeometryParser(text, name, keep_going).parse();
}

}  // namespace dapple::obj
