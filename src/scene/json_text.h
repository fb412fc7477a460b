// Numbers and vectors as JSON that reads back bit for bit.
#pragma once

#include <string>
#include <string_view>

#include "math/vec3.h"
#include "util/text_sink.h"

namespace dapple {

// A number as the shortest text that reads back as the same one of its type; null for what is not
// finite. One without a decimal point or an exponent gets a point: a reader may take -0 for an
// integer and lose its sign.
[[nodiscard]] std::string json_number(double value);
[[nodiscard]] std::string json_number(float value);
// With quotation marks; the text is UTF-8.
[[nodiscard]] std::string json_string(std::string_view text);

template <class T>
void print_json_vector(std::string_view name, const Vec3<T>& v, TextWriter& out) {
  out.print("\"{}\":[{},{},{}]", name, json_number(v.x), json_number(v.y), json_number(v.z));
}

}  // namespace dapple
