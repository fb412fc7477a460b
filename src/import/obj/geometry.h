// What an OBJ file says, with every index resolved and proven.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec2.h"
#include "math/vec3.h"
#include "util/error.h"

namespace dapple::obj {

inline constexpr std::uint32_t kNone = 0xffffffffu;

// Indices into the arrays of Geometry; uv and normal may be kNone.
struct Corner {
  std::uint32_t position = kNone, uv = kNone, normal = kNone;
};

enum class ElementKind : std::uint8_t { face, line, points };

struct Element {
  std::size_t first_corner = 0;    // up to that of the next element
  std::uint32_t material = kNone;  // index of Geometry::materials
  std::uint32_t smoothing = 0;     // 0: off
  ElementKind kind = ElementKind::face;
};

// The words after "mtllib".
struct Libraries {
  std::string names;
  std::size_t line = 0;
};

struct Geometry {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> colours;  // as the file says them; empty, or as many as positions
  std::vector<Vec3f> normals;
  std::vector<Vec2f> uvs;
  std::vector<Corner> corners;
  std::vector<Element> elements;
  std::vector<std::string> materials;  // names in the order of their first use
  std::vector<Libraries> libraries;    // a line each
  std::vector<std::string> warnings;   // with their place
  std::size_t small_faces = 0;         // with fewer than three corners; left out
  std::size_t broken_elements = 0;     // with an index that names nothing; left out
  std::string broken_reason;           // of the first of them found, with its place

  std::size_t end_of(std::size_t element) const {
    return element + 1 < elements.size() ? elements[element + 1].first_corner : corners.size();
  }
};

// `name` is the file's, for errors. An index that names nothing is one, or with `keep_going` leaves
// out the element that has it.
[[nodiscard]] Expected<Geometry> read_geometry(std::string_view text, std::string_view name,
                                               bool keep_going = false);

}  // namespace dapple::obj
