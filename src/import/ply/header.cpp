#include "import/ply/header.h"

#include <fmt/format.h>

#include <optional>

#include "import/limits.h"
#include "import/text.h"

namespace dapple::ply {
namespace {

struct TypeName {
  std::string_view name;
  Type type;
};
constexpr TypeName kTypeNames[] = {
    {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
    {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
    {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
    {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64},
};

std::optional<Type> type_of(std::string_view name) {
  for (const TypeName& known : kTypeNames) {
    if (known.name == name) return known.type;
  }
  return std::nullopt;
}

class HeaderParser {
 public:
  HeaderParser(std::string_view text, std::string_view name) : lines_(text), name_(name) {}

  Expected<Header> parse() {
    std::string_view line;
    if (!lines_.next(line) || trimmed(line) != "ply") {
      return bad("a PLY file begins with the line 'ply'");
    }
    while (lines_.next(line)) {
      WordReader words(line);
      const std::string_view keyword = words.next();
      if (keyword == "end_header") return finished();
      if (auto status = statement(keyword, words); !status) return tl::unexpected(status.error());
    }
    return bad("the file ends within its header");
  }

 private:
  tl::unexpected<Error> bad(std::string message) const {
    return fail(Errc::bad_data, line_place(name_, lines_.number()), std::move(message));
  }

  Expected<Header> finished() {
    if (!has_format_) return bad("the header names no format");
    header_.bytes = lines_.position();
    header_.lines = lines_.number();
    return std::move(header_);
  }

  Status statement(std::string_view keyword, WordReader& words) {
    if (keyword == "format") return format(words);
    if (keyword == "element") return element(words);
    if (keyword == "property") return property(words);
    if (keyword == "comment") {
      if (words.next() == "TextureFile") header_.texture_file = words.rest();
      return {};
    }
    if (keyword == "obj_info" || keyword.empty()) return {};
    return bad(fmt::format("unknown word '{:.40}' in the header", keyword));
  }

  Status format(WordReader& words) {
    const std::string_view name = words.next(), version = words.next();
    if (version != "1.0") return bad(fmt::format("version '{:.40}' of PLY is not known", version));
    if (name == "ascii") {
      header_.format = Format::ascii;
    } else if (name == "binary_little_endian") {
      header_.format = Format::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = Format::big_endian;
    } else {
      return bad(fmt::format("unknown format '{:.40}'", name));
    }
    has_format_ = true;
    return {};
  }

  Status element(WordReader& words) {
    Element element;
    element.name = words.next();
    const auto count = to_integer(words.next());
    if (element.name.empty() || !count || *count < 0) {
      return bad("an element needs a name and a count");
    }
    if (static_cast<std::uint64_t>(*count) >= kMaxTriangleCount) {
      return bad(fmt::format("{} elements are more than {}", *count, kMaxTriangleCount - 1));
    }
    if (header_.elements.size() == kMaxElements) return bad("too many kinds of elements");
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(std::move(element));
    return {};
  }

  Status property(WordReader& words) {
    if (header_.elements.empty()) return bad("a property stands before the first element");
    auto& properties = header_.elements.back().properties;
    if (properties.size() == kMaxProperties) return bad("too many properties");
    Property property;
    std::string_view type_name = words.next();
    if (type_name == "list") {
      property.is_list = true;
      const std::string_view count_name = words.next();
      const auto count_type = type_of(count_name);
      if (!count_type || *count_type == Type::f32 || *count_type == Type::f64) {
        return bad(fmt::format("'{:.40}' is no type for a list's length", count_name));
      }
      property.count_type = *count_type;
      type_name = words.next();
    }
    const auto type = type_of(type_name);
    if (!type) return bad(fmt::format("unknown type '{:.40}'", type_name));
    property.type = *type;
    property.name = words.next();
    if (property.name.empty()) return bad("a property has no name");
    properties.push_back(std::move(property));
    return {};
  }

  LineReader lines_;
  std::string_view name_;
  Header header_;
  bool has_format_ = false;
};

Status check_size(const Header& header, std::size_t file_bytes, std::string_view name) {
  std::uint64_t left = file_bytes > header.bytes ? file_bytes - header.bytes : 0;
  // The last line of an ascii file may lack its end.
  if (header.format == Format::ascii) ++left;
  for (const Element& element : header.elements) {
    if (element.properties.empty() && element.count > 0) {
      return fail(Errc::bad_data, std::string(name),
                  fmt::format("the element '{:.40}' has no properties", element.name));
    }
    const std::uint64_t least = element.count * element.min_bytes(header.format);
    if (least > left) {
      return fail(Errc::bad_data, byte_place(name, file_bytes),
                  fmt::format("the file ends here, too short for its {} elements '{:.40}'",
                              element.count, element.name));
    }
    left -= least;
  }
  return {};
}

}  // namespace

std::size_t Element::min_bytes(Format format) const {
  if (format == Format::ascii) return 2 * properties.size();  // a digit and a separator
  std::size_t bytes = 0;
  for (const Property& property : properties) {
    bytes += bytes_of(property.is_list ? property.count_type : property.type);
  }
  return bytes;
}

Expected<Header> read_header(std::span<const std::byte> bytes, std::string_view name) {
  auto header = HeaderParser(as_text(bytes), name).parse();
  if (!header) return header;
  if (auto status = check_size(*header, bytes.size(), name); !status) {
    return tl::unexpected(status.error());
  }
  return header;
}

}  // namespace dapple::ply
