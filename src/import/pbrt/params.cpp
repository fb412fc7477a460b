#include "import/pbrt/params.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/text.h"

namespace dapple::pbrt {
namespace {

constexpr std::string_view kNumberTypes[] = {"integer", "float",   "point2",    "vector2", "point3",
                                             "vector3", "normal3", "point",     "vector",  "normal",
                                             "rgb",     "color",   "blackbody", "xyz"};

bool holds_numbers(std::string_view type) {
  return std::ranges::find(kNumberTypes, type) != std::end(kNumberTypes);
}

class ParamsReader {
 public:
  ParamsReader(Lexer& lexer) : lexer_(lexer) {}

  Expected<std::vector<Param>> read() {
    std::vector<Param> params;
    for (;;) {
      const auto token = lexer_.next();
      if (!token) return tl::unexpected(token.error());
      if (!*token) return params;
      if ((*token)->kind != TokenKind::text) {
        lexer_.put_back(**token);
        return params;
      }
      auto param = named(**token);
      if (!param) return tl::unexpected(param.error());
      if (auto filled = fill(*param); !filled) return tl::unexpected(filled.error());
      params.push_back(std::move(*param));
    }
  }

 private:
  Expected<Param> named(const Token& token) const {
    WordReader words(token.text);
    Param param;
    param.type = words.next();
    param.name = words.next();
    param.place = lexer_.place(token);
    if (param.name.empty() || !words.rest().empty()) {
      return fail(Errc::bad_data, param.place,
                  fmt::format("'{:.60}' is not the type and name of a parameter", token.text));
    }
    return param;
  }

  // One value, or several between brackets.
  Status fill(Param& param) {
    bool in_brackets = false;
    for (;;) {
      const auto token = lexer_.next();
      if (!token) return tl::unexpected(token.error());
      if (!*token) return fail(Errc::bad_data, param.place, "the file ends within a parameter");
      const TokenKind kind = (*token)->kind;
      if (kind == TokenKind::open && !in_brackets) {
        in_brackets = true;
      } else if (kind == TokenKind::close && in_brackets) {
        return {};
      } else if (kind == TokenKind::open || kind == TokenKind::close) {
        return fail(Errc::bad_data, lexer_.place(**token), "a bracket is out of place");
      } else {
        if (auto added = add(**token, param); !added) return added;
        if (!in_brackets) return {};
      }
    }
  }

  Status add(const Token& token, Param& param) const {
    const bool is_truth = token.text == "true" || token.text == "false";
    if (token.kind == TokenKind::text || (param.type == "bool" && is_truth)) {
      if (holds_numbers(param.type)) {
        return fail(Errc::bad_data, lexer_.place(token),
                    fmt::format("'{:.60}' stands where a number should", token.text));
      }
      param.texts.emplace_back(token.text);
      return {};
    }
    const auto value = to_number(token.text);
    if (!value || !std::isfinite(*value)) {
      return fail(Errc::bad_data, lexer_.place(token),
                  fmt::format("'{:.60}' is not a finite number", token.text));
    }
    param.numbers.push_back(*value);
    return {};
  }

  Lexer& lexer_;
};

}  // namespace

const Param* Params::find(std::string_view name,
                          std::initializer_list<std::string_view> types) const {
  for (const Param& param : params_) {
    if (param.name != name) continue;
    const bool fits = std::ranges::any_of(
        types, [&](std::string_view type) { return type.empty() || type == param.type; });
    if (!fits) continue;
    param.used = true;
    return &param;
  }
  return nullptr;
}

double Params::number(std::string_view name, double otherwise) const {
  const Param* param = find(name, {"float", "integer"});
  return param == nullptr || param->numbers.empty() ? otherwise : param->numbers[0];
}

bool Params::truth(std::string_view name, bool otherwise) const {
  const Param* param = find(name, {"bool"});
  return param == nullptr || param->texts.empty() ? otherwise : param->texts[0] == "true";
}

std::string Params::text(std::string_view name, std::string_view otherwise) const {
  const Param* param = find(name, {"string", "texture"});
  return param == nullptr || param->texts.empty() ? std::string(otherwise) : param->texts[0];
}

std::vector<double> Params::numbers(std::string_view name) const {
  const Param* param = find(name, {""});
  return param == nullptr ? std::vector<double>() : param->numbers;
}

std::vector<Vec3f> Params::vectors(std::string_view name) const {
  std::vector<Vec3f> vectors;
  const Param* param = find(name, {"point3", "vector3", "normal3", "point", "vector", "normal"});
  if (param == nullptr) return vectors;
  vectors.reserve(param->numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < param->numbers.size(); i += 3) {
    vectors.emplace_back(to_float(param->numbers[i]), to_float(param->numbers[i + 1]),
                         to_float(param->numbers[i + 2]));
  }
  return vectors;
}

std::optional<Vec3d> Params::vector(std::string_view name) const {
  const Param* param = find(name, {"point3", "vector3", "normal3", "point", "vector", "normal"});
  if (param == nullptr || param->numbers.size() < 3) return std::nullopt;
  return Vec3d(param->numbers[0], param->numbers[1], param->numbers[2]);
}

std::vector<const Param*> Params::unused() const {
  std::vector<const Param*> unused;
  for (const Param& param : params_) {
    if (!param.used) unused.push_back(&param);
  }
  return unused;
}

Expected<Params> read_params(Lexer& lexer, std::string place) {
  return ParamsReader(lexer).read().map(
      [&](std::vector<Param> params) { return Params(std::move(params), std::move(place)); });
}

}  // namespace dapple::pbrt
