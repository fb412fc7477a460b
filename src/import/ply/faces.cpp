#include "import/ply/faces.h"

#include <fmt/format.h>

#include "import/polygon.h"

namespace dapple::ply {
namespace {

bool holds_indices(const Property& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// Calls take(list of vertex indices) for each row; the indices are those of vertices that exist,
// or -1 where `restart` allows it.
template <class Take>
Status read_lists(ValueReader& values, const Element& element, Model& model, bool restart,
                  Take&& take) {
  const auto vertex_count = static_cast<double>(model.mesh.vertices.positions.size());
  for (const Property& property : element.properties) {
    if (!holds_indices(property))
      model.ignored.push_back(element.name + " property " + property.name);
  }
  std::vector<std::int64_t> list;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    list.clear();
    bool broken = false;
    for (const Property& property : element.properties) {
      if (!holds_indices(property)) {
        values.skip(property);
        continue;
      }
      const std::size_t count = values.next_count(property);
      for (std::size_t i = 0; i < count && !values.bad(); ++i) {
        const double index = values.next(property.type);
        if (!(index >= 0 && index < vertex_count) && !(restart && index == -1)) {
          const auto error = values.error(
              fmt::format("{} {} names vertex {} of {}", element.name, row, index, vertex_count));
          if (values.bad() || !model.keep_going) return error;
          if (!broken && model.broken_faces++ == 0) model.broken_reason = to_string(error.value());
          broken = true;
          continue;
        }
        list.push_back(static_cast<std::int64_t>(index));
      }
    }
    if (values.bad()) return values.error();
    if (!broken) take(list);
  }
  return {};
}

void add_polygon(const std::vector<std::int64_t>& polygon, std::vector<Vec3f>& positions,
                 std::vector<Corners>& cut, MeshData& mesh) {
  positions.clear();
  cut.clear();
  for (const std::int64_t index : polygon) {
    positions.push_back(mesh.vertices.positions[static_cast<std::size_t>(index)]);
  }
  triangulate(positions, cut);
  for (const Corners& corners : cut) {
    Triangle triangle;
    for (int i = 0; i < 3; ++i) {
      triangle.vertices[i] = static_cast<std::uint32_t>(polygon[corners[i]]);
    }
    mesh.triangles.push_back(triangle);
  }
}

void add_strip(const std::vector<std::int64_t>& strip, std::vector<Triangle>& triangles) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    if (strip[i] < 0) {
      start = i + 1;
    } else if (i >= start + 2) {
      const auto a = static_cast<std::uint32_t>(strip[i - 2]);
      const auto b = static_cast<std::uint32_t>(strip[i - 1]);
      const auto c = static_cast<std::uint32_t>(strip[i]);
      triangles.push_back((i - start) % 2 == 0 ? Triangle{{a, b, c}} : Triangle{{b, a, c}});
    }
  }
}

}  // namespace

Status read_faces(ValueReader& values, const Element& element, Model& model) {
  std::vector<Vec3f> positions;
  std::vector<Corners> cut;
  return read_lists(values, element, model, false, [&](const std::vector<std::int64_t>& polygon) {
    if (polygon.size() < 3) {
      ++model.skipped_faces;
    } else {
      add_polygon(polygon, positions, cut, model.mesh);
    }
  });
}

Status read_strips(ValueReader& values, const Element& element, Model& model) {
  return read_lists(values, element, model, true, [&](const std::vector<std::int64_t>& strip) {
    add_strip(strip, model.mesh.triangles);
  });
}

}  // namespace dapple::ply
