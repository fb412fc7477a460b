#include "import/obj/smoothing.h"

#include <algorithm>
#include <span>

namespace dapple::obj {
namespace {

struct SmoothCorner {
  std::uint32_t position = 0;
  std::uint32_t group = 0;
  std::size_t corner = 0;
  Vec3f area;  // of its face, as a vector along the normal
};

// Half the sum of the cross products around the face: its area times its normal.
Vec3f face_area(const Geometry& geometry, std::span<const Corner> corners) {
  const Vec3d origin(geometry.positions[corners[0].position]);
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum = sum + cross(Vec3d(geometry.positions[corners[i].position]) - origin,
                      Vec3d(geometry.positions[corners[i + 1].position]) - origin);
  }
  return is_finite(sum) ? Vec3f(0.5 * sum) : Vec3f();
}

bool same_place(const SmoothCorner& a, const SmoothCorner& b) {
  return a.position == b.position && a.group == b.group;
}

Vec3f unit_or_zero(const Vec3d& v) {
  const double size = length(v);
  return size > 0 && std::isfinite(size) ? Vec3f(v / size) : Vec3f();
}

std::vector<SmoothCorner> corners_to_smooth(const Geometry& geometry) {
  std::vector<SmoothCorner> found;
  for (std::size_t e = 0; e < geometry.elements.size(); ++e) {
    const Element& element = geometry.elements[e];
    if (element.kind != ElementKind::face || element.smoothing == 0) continue;
    const std::span corners(geometry.corners.begin() + element.first_corner,
                            geometry.corners.begin() + geometry.end_of(e));
    if (std::ranges::none_of(corners, [](const Corner& c) { return c.normal == kNone; })) continue;
    const Vec3f area = face_area(geometry, corners);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      found.push_back({corners[i].position, element.smoothing, element.first_corner + i, area});
    }
  }
  return found;
}

}  // namespace

void add_smooth_normals(Geometry& geometry) {
  auto found = corners_to_smooth(geometry);
  std::ranges::sort(found, [](const SmoothCorner& a, const SmoothCorner& b) {
    return std::tie(a.position, a.group, a.corner) < std::tie(b.position, b.group, b.corner);
  });
  for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
    Vec3d sum;
    for (end = begin; end < found.size() && same_place(found[begin], found[end]); ++end) {
      sum = sum + Vec3d(found[end].area);
    }
    const auto index = static_cast<std::uint32_t>(geometry.normals.size());
    geometry.normals.push_back(unit_or_zero(sum));
    for (std::size_t i = begin; i < end; ++i) {
      Corner& corner = geometry.corners[found[i].corner];
      if (corner.normal == kNone) corner.normal = index;
    }
  }
}

}  // namespace dapple::obj
