#include "import/polygon.h"

#include <cmath>
#include <numeric>

namespace dapple {
namespace {

struct Point {
  double x = 0, y = 0;
};

// Twice the signed area of a triangle.
double area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Newell's method: right for concave polygons and for those that are not quite flat.
Vec3d normal_of(std::span<const Vec3f> polygon) {
  Vec3d normal;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d a(polygon[i] - polygon[0]);
    const Vec3d b(polygon[(i + 1) % polygon.size()] - polygon[0]);
    normal = normal + cross(a, b);
  }
  return normal;
}

// Seen along the normal's largest axis, turning counter-clockwise.
std::vector<Point> projected(std::span<const Vec3f> polygon) {
  const Vec3d normal = normal_of(polygon);
  const Vec3d size(std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z));
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double sign = normal[axis] < 0 ? -1 : 1;
  std::vector<Point> points;
  points.reserve(polygon.size());
  for (const Vec3f& p : polygon) points.push_back({sign * double(p[u]), double(p[v])});
  return points;
}

class EarCutter {
 public:
  EarCutter(std::vector<Point> points, std::vector<Corners>& triangles)
      : points_(std::move(points)), left_(points_.size()), triangles_(triangles) {
    std::iota(left_.begin(), left_.end(), 0u);
  }

  bool is_convex() const {
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (turn(i) < 0) return false;
    }
    return true;
  }

  void cut() {
    std::size_t tried = 0, i = 0;
    while (left_.size() > 3 && tried < left_.size()) {
      if (is_ear(i)) {
        triangles_.push_back({corner(i, -1), left_[i], corner(i, 1)});
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
        tried = 0;
      } else {
        ++i;
        ++tried;
      }
      if (i >= left_.size()) i = 0;
    }
    fan();
  }

  void fan() {
    for (std::size_t i = 1; i + 1 < left_.size(); ++i) {
      triangles_.push_back({left_[0], left_[i], left_[i + 1]});
    }
  }

 private:
  std::uint32_t corner(std::size_t i, int step) const {
    return left_[(i + left_.size() + static_cast<std::size_t>(step)) % left_.size()];
  }

  double turn(std::size_t i) const {
    return area(points_[corner(i, -1)], points_[left_[i]], points_[corner(i, 1)]);
  }

  // A corner that turns left and whose triangle holds no other corner.
  bool is_ear(std::size_t i) const {
    if (!(turn(i) > 0)) return false;
    const Point &a = points_[corner(i, -1)], &b = points_[left_[i]], &c = points_[corner(i, 1)];
    for (const std::uint32_t other : left_) {
      if (other == left_[i] || other == corner(i, -1) || other == corner(i, 1)) continue;
      const Point& p = points_[other];
      const bool is_corner =
          (p.x == a.x && p.y == a.y) || (p.x == b.x && p.y == b.y) || (p.x == c.x && p.y == c.y);
      if (!is_corner && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) {
        return false;
      }
    }
    return true;
  }

  std::vector<Point> points_;
  std::vector<std::uint32_t> left_;
  std::vector<Corners>& triangles_;
};

}  // namespace

void triangulate(std::span<const Vec3f> polygon, std::vector<Corners>& triangles) {
  if (polygon.size() < 3) return;
  if (polygon.size() == 3) {
    triangles.push_back({0, 1, 2});
    return;
  }
  EarCutter cutter(projected(polygon), triangles);
  if (polygon.size() > kMaxConcaveCorners || cutter.is_convex()) {
    cutter.fan();
  } else {
    cutter.cut();
  }
}

}  // namespace dapple
