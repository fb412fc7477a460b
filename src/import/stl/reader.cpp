#include "import/stl/reader.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "import/limits.h"
#include "import/stl/weld.h"
#include "import/text.h"

namespace dapple::stl {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFirstFacet = kHeaderBytes + 4;
constexpr std::size_t kFacetBytes = 50;  // normal, three corners, two bytes of attributes
constexpr std::size_t kNormalBytes = 12;

static_assert(std::endian::native == std::endian::little);

std::uint64_t declared_facets(std::span<const std::byte> bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderBytes, sizeof count);
  return count;
}

bool is_binary(std::span<const std::byte> bytes) {
  if (bytes.size() < kFirstFacet) return false;
  if (bytes.size() == kFirstFacet + declared_facets(bytes) * kFacetBytes) return true;
  // Text has no zeros: a binary file whose header begins like text, and which is cut short.
  if (as_text(bytes.first(kFirstFacet)).find('\0') != std::string_view::npos) return true;
  return !trimmed(as_text(bytes.first(kHeaderBytes))).starts_with("solid");
}

Expected<Model> read_binary(std::span<const std::byte> bytes, std::string_view name) {
  const std::uint64_t count = declared_facets(bytes);
  const std::uint64_t there = (bytes.size() - kFirstFacet) / kFacetBytes;
  if (count > there) {
    return fail(Errc::bad_data, byte_place(name, kHeaderBytes),
                fmt::format("the file promises {} facets and has {}", count, there));
  }
  if (count >= kMaxTriangleCount) {
    return fail(Errc::bad_data, byte_place(name, kHeaderBytes),
                fmt::format("{} facets are too many", count));
  }
  Model model;
  if (bytes.size() > kFirstFacet + count * kFacetBytes) {
    model.warnings.push_back(fmt::format("{}: bytes behind the last facet are left out",
                                         byte_place(name, kFirstFacet + count * kFacetBytes)));
  }
  Weld weld(model.mesh, count);
  for (std::uint64_t i = 0; i < count; ++i) {
    float corners[9];
    std::memcpy(corners, bytes.data() + kFirstFacet + i * kFacetBytes + kNormalBytes,
                sizeof corners);
    weld.add({corners[0], corners[1], corners[2]}, {corners[3], corners[4], corners[5]},
             {corners[6], corners[7], corners[8]});
  }
  return model;
}

// facet normal .. outer loop vertex .. vertex .. vertex .. endloop endfacet, one statement a line.
class TextParser {
 public:
  TextParser(std::string_view text, std::string_view name) : lines_(text), name_(name) {}

  Expected<Model> parse() {
    Weld weld(model_.mesh, 0);
    std::string_view line;
    while (lines_.next(line)) {
      WordReader words(line);
      const std::string keyword = in_lower_case(words.next());
      if (keyword == "vertex") {
        if (auto status = vertex(words); !status) return tl::unexpected(status.error());
      } else if (keyword == "endloop" || keyword == "endfacet") {
        if (auto status = end_facet(weld); !status) return tl::unexpected(status.error());
      } else if (!is_known(keyword)) {
        return bad(fmt::format("'{:.40}' is no word of an STL file", keyword));
      }
    }
    if (!corners_.empty()) return bad("the file ends within a facet");
    return std::move(model_);
  }

 private:
  static bool is_known(const std::string& keyword) {
    return keyword.empty() || keyword == "facet" || keyword == "outer" || keyword == "solid" ||
           keyword == "endsolid" || keyword == "color";
  }

  tl::unexpected<Error> bad(std::string message) const {
    return fail(Errc::bad_data, line_place(name_, lines_.number()), std::move(message));
  }

  Status vertex(WordReader& words) {
    Vec3f position;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = words.next();
      const auto value = to_number(word);
      if (!value) return bad(fmt::format("'{:.40}' is not a number", word));
      position[axis] = to_float(*value);
    }
    if (corners_.size() == 3) return bad("a facet has more than three vertices");
    corners_.push_back(position);
    return {};
  }

  Status end_facet(Weld& weld) {
    if (corners_.empty()) return {};
    if (corners_.size() < 3) return bad("a facet has fewer than three vertices");
    weld.add(corners_[0], corners_[1], corners_[2]);
    corners_.clear();
    return {};
  }

  LineReader lines_;
  std::string_view name_;
  Model model_;
  std::vector<Vec3f> corners_;
};

}  // namespace

Expected<Model> read(std::span<const std::byte> bytes, std::string_view name) {
  if (is_binary(bytes)) return read_binary(bytes, name);
  const std::string_view text = as_text(bytes);
  if (!in_lower_case(trimmed(text.substr(0, kHeaderBytes))).starts_with("solid")) {
    return fail(Errc::bad_data, std::string(name),
                "neither a binary STL file nor one that begins with 'solid'");
  }
  return TextParser(text, name).parse();
}

}  // namespace dapple::stl
