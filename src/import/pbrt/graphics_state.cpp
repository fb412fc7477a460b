#include "import/pbrt/graphics_state.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "import/text.h"
#include "math/functions.h"

namespace dapple::pbrt {
namespace {

Transformd from_columns(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin) {
  Transformd m;
  const Vec3d columns[4] = {x, y, z, origin};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) m.rows[i][j] = columns[j][i];
  }
  return m;
}

Transformd translation(const double* n) {
  return from_columns({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {n[0], n[1], n[2]});
}
Transformd scaling(const double* n) {
  return from_columns({n[0], 0, 0}, {0, n[1], 0}, {0, 0, n[2]}, {});
}

// By an angle in degrees about an axis, after Rodrigues.
std::optional<Transformd> rotation(const double* n) {
  const Vec3d given(n[1], n[2], n[3]);
  if (!(length(given) > 0)) return std::nullopt;
  const Vec3d a = normalize(given);
  const auto [s, c] = sin_cos_turns(n[0] / 360);
  const double sine = s, cosine = c;
  const auto turned = [&](const Vec3d& v) {
    return cosine * v + sine * cross(a, v) + (dot(a, v) * (1 - cosine)) * a;
  };
  return from_columns(turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {});
}

// From the world to a camera at `eye` that looks along its z.
std::optional<Transformd> look_at(const double* n) {
  const Vec3d eye(n[0], n[1], n[2]), at(n[3], n[4], n[5]), up(n[6], n[7], n[8]);
  const Vec3d sideways = cross(up, at - eye);
  if (!(length(sideways) > 0)) return std::nullopt;
  const Vec3d right = normalize(sideways), forward = normalize(at - eye);
  return inverse(from_columns(right, cross(forward, right), forward, eye));
}

// Sixteen numbers, column by column; the last row must be that of an affine map.
std::optional<Transformd> matrix(const double* n) {
  if (n[3] != 0 || n[7] != 0 || n[11] != 0 || n[15] != 1) return std::nullopt;
  return from_columns({n[0], n[1], n[2]}, {n[4], n[5], n[6]}, {n[8], n[9], n[10]},
                      {n[12], n[13], n[14]});
}

struct TransformKind {
  std::string_view directive;
  int numbers;
};
constexpr TransformKind kKinds[] = {{"Identity", 0},        {"Translate", 3}, {"Scale", 3},
                                    {"Rotate", 4},          {"LookAt", 9},    {"Transform", 16},
                                    {"ConcatTransform", 16}};

// With or without brackets around them.
Expected<std::array<double, 16>> numbers(Lexer& lexer, int count) {
  std::array<double, 16> result{};
  bool in_brackets = false;
  for (int i = 0; i < count || in_brackets;) {
    const auto token = lexer.next();
    if (!token) return tl::unexpected(token.error());
    if (!*token) return fail(Errc::bad_data, lexer.place(), "the file ends within a directive");
    if ((*token)->kind == TokenKind::open && i == 0 && !in_brackets) {
      in_brackets = true;
    } else if ((*token)->kind == TokenKind::close && i == count && in_brackets) {
      in_brackets = false;
    } else {
      const auto value = to_number((*token)->text);
      if (i == count || !value || !std::isfinite(*value)) {
        return fail(Errc::bad_data, lexer.place(**token),
                    fmt::format("'{:.40}' is not one of {} finite numbers", (*token)->text, count));
      }
      result[static_cast<std::size_t>(i++)] = *value;
    }
  }
  return result;
}

std::optional<Transformd> transform_of(std::string_view directive, const double* n) {
  if (directive == "Translate") return translation(n);
  if (directive == "Scale") return scaling(n);
  if (directive == "Rotate") return rotation(n);
  if (directive == "LookAt") return look_at(n);
  return matrix(n);
}

}  // namespace

Status GraphicsStates::push(const std::string& place) {
  if (stack_.size() == kMaxDepth) return fail(Errc::bad_data, place, "nested too deeply");
  stack_.push_back(now_);
  return {};
}

Status GraphicsStates::pop(const std::string& place) {
  if (stack_.empty()) return fail(Errc::bad_data, place, "an end without a beginning");
  now_ = std::move(stack_.back());
  stack_.pop_back();
  return {};
}

Status GraphicsStates::pop_transform(const std::string& place) {
  if (stack_.empty()) return fail(Errc::bad_data, place, "an end without a beginning");
  now_.to_world = stack_.back().to_world;
  stack_.pop_back();
  return {};
}

void GraphicsStates::begin_world() {
  now_.to_world = {};
  systems_["world"] = {};
}

Expected<bool> GraphicsStates::named_system(std::string_view directive, Lexer& lexer) {
  const auto token = lexer.next();
  if (!token) return tl::unexpected(token.error());
  if (!*token || (*token)->kind != TokenKind::text) {
    return fail(Errc::bad_data, lexer.place(), "the name of a coordinate system is missing");
  }
  const std::string name((*token)->text);
  if (directive == "CoordinateSystem") {
    systems_[name] = now_.to_world;
    return true;
  }
  const auto found = systems_.find(name);
  if (found == systems_.end()) {
    return fail(Errc::bad_data, lexer.place(**token), "there is no coordinate system of this name");
  }
  now_.to_world = found->second;
  return true;
}

Expected<bool> GraphicsStates::transform(std::string_view directive, Lexer& lexer) {
  if (directive == "CoordinateSystem" || directive == "CoordSysTransform") {
    return named_system(directive, lexer);
  }
  const TransformKind* kind = nullptr;
  for (const TransformKind& known : kKinds) {
    if (known.directive == directive) kind = &known;
  }
  if (kind == nullptr) return false;
  const std::string place = lexer.place();
  const auto n = numbers(lexer, kind->numbers);
  if (!n) return tl::unexpected(n.error());
  if (directive == "Identity") {
    now_.to_world = {};
    return true;
  }
  const auto made = transform_of(directive, n->data());
  if (!made) return fail(Errc::bad_data, place, "the numbers make no affine transformation");
  now_.to_world = directive == "Transform" ? *made : now_.to_world * *made;
  return true;
}

}  // namespace dapple::pbrt
