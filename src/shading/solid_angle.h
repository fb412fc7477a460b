// Triangles and rectangles as they are seen from a point, sampled so that every direction in which
// they lie is equally probable. Near ones look very unlike what their area says.
#pragma once

#include "math/vec2.h"
#include "math/vec3.h"

namespace dapple {

// By [Arvo95].
class SeenTriangle {
 public:
  // `corner` from the point of view; the others are at corner + edge1 and corner + edge2.
  SeenTriangle(const Vec3f& corner, const Vec3f& edge1, const Vec3f& edge2);

  // 0 when the triangle is far, so that sampling it by area does as well, or the angle so small or
  // large that rounding spoils the sampling below, which must not be used then.
  float solid_angle() const { return solid_angle_; }
  // A point of it, as factors of the two edges.
  Vec2f sample(Vec2f u) const;

 private:
  Vec3f corner_, edge1_, edge2_;
  Vec3f a_, b_, c_;  // directions of the corners, counter-clockwise
  float solid_angle_ = 0;
};

// By [UrenaFK13]; the edges are at right angles.
class SeenRectangle {
 public:
  SeenRectangle(const Vec3f& corner, const Vec3f& edge1, const Vec3f& edge2);

  float solid_angle() const { return solid_angle_; }
  Vec2f sample(Vec2f u) const;

 private:
  float x0_, x1_, y0_, y1_, z0_;
  float b0_ = 0, b1_ = 0, k_ = 0;
  float solid_angle_ = 0;
};

}  // namespace dapple
