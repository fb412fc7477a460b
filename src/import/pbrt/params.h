// Lists of parameters: "type name" [ values ].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/pbrt/lexer.h"
#include "math/vec3.h"

namespace dapple::pbrt {

struct Param {
  std::string type, name;
  std::vector<double> numbers;
  std::vector<std::string> texts;  // strings; "true" and "false" of a bool
  std::string place;
  mutable bool used = false;
};

class Params {
 public:
  Params() = default;
  Params(std::vector<Param> params, std::string place)
      : params_(std::move(params)), place_(std::move(place)) {}

  // One of that name and any of the types ("" for every one), marked as used; or nullptr.
  const Param* find(std::string_view name, std::initializer_list<std::string_view> types) const;

  double number(std::string_view name, double otherwise) const;
  bool truth(std::string_view name, bool otherwise) const;
  std::string text(std::string_view name, std::string_view otherwise) const;
  std::vector<double> numbers(std::string_view name) const;
  // Triples of "point", "normal" and the like; a number too many is left out.
  std::vector<Vec3f> vectors(std::string_view name) const;
  std::optional<Vec3d> vector(std::string_view name) const;

  std::vector<const Param*> unused() const;
  const std::string& place() const { return place_; }  // of the directive

 private:
  std::vector<Param> params_;
  std::string place_;
};

// As far as it goes: the next word is a directive. Every number is finite.
[[nodiscard]] Expected<Params> read_params(Lexer& lexer, std::string place);

}  // namespace dapple::pbrt
