#include "scene/vertex_arrays.h"

namespace dapple {
namespace {

template <class T>
void append(const std::vector<T>& from, std::size_t from_count, std::vector<T>& to,
            std::size_t to_count, const T& none) {
  if (from.empty() && to.empty()) return;
  if (to.empty()) to.assign(to_count, none);
  if (from.empty()) {
    to.resize(to_count + from_count, none);
  } else {
    to.insert(to.end(), from.begin(), from.end());
  }
}

}  // namespace

void append_vertices(const Vertices& from, Vertices& to) {
  const std::size_t from_count = from.positions.size();
  const std::size_t to_count = to.positions.size();
  append(from.normals, from_count, to.normals, to_count, Vec3f());
  append(from.tangents, from_count, to.tangents, to_count, Vec4f());
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    append(from.uvs[set], from_count, to.uvs[set], to_count, Vec2f());
  }
  append(from.colours, from_count, to.colours, to_count, Vec4f{1, 1, 1, 1});
  to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
}

}  // namespace dapple
