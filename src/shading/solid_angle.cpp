#include "shading/solid_angle.h"

#include <algorithm>
#include <cmath>

#include "math/fast_functions.h"

namespace dapple {
namespace {

constexpr float kLeast = 0.02f, kMost = 6.25f;  // solid angles
// From this many edges away sampling by area is hardly worse, and cheaper.
constexpr float kFar = 2.5f;

bool is_far(const Vec3f& corner, const Vec3f& edge1, const Vec3f& edge2) {
  const float edges = std::max(dot(edge1, edge1), dot(edge2, edge2));
  return !(dot(corner, corner) < kFar * kFar * edges);
}

float usable(float solid_angle) {
  return solid_angle > kLeast && solid_angle < kMost ? solid_angle : 0.0f;
}

// The part of v at right angles to the unit vector n, as a unit vector.
Vec3f beside(const Vec3f& v, const Vec3f& n) { return normalize(v - dot(v, n) * n); }

float root(float x) { return std::sqrt(std::max(x, 0.0f)); }

}  // namespace

SeenTriangle::SeenTriangle(const Vec3f& corner, const Vec3f& edge1, const Vec3f& edge2)
    : corner_(corner), edge1_(edge1), edge2_(edge2) {
  if (is_far(corner, edge1, edge2)) return;
  a_ = normalize(corner);
  b_ = normalize(corner + edge1);
  c_ = normalize(corner + edge2);
  float volume = dot(a_, cross(b_, c_));
  if (volume < 0.0f) {
    std::swap(b_, c_);
    volume = -volume;
  }
  // [VanOosteromS83]
  const float below = 1.0f + dot(a_, b_) + dot(b_, c_) + dot(c_, a_);
  solid_angle_ = usable(2.0f * fast_atan2(volume, below));
}

Vec2f SeenTriangle::sample(Vec2f u) const {
  // Cut off the share u.x of the solid angle by an arc from b to a point of the side from a to c.
  const Vec3f to_b = beside(b_, a_), to_c = beside(c_, a_);
  const float cos_alpha = dot(to_b, to_c), sin_alpha = dot(a_, cross(to_b, to_c));
  const SinCos<float> part = sin_cos(u.x * solid_angle_);
  const float s = part.sin * cos_alpha - part.cos * sin_alpha;
  const float t = part.cos * cos_alpha + part.sin * sin_alpha;
  const float p = t - cos_alpha, v = s + sin_alpha * dot(a_, b_);
  const float above = (v * t - p * s) * cos_alpha - v, below = (v * s + p * t) * sin_alpha;
  const float q = below != 0.0f ? std::clamp(above / below, -1.0f, 1.0f) : 1.0f;
  const Vec3f on_side = q * a_ + root((1.0f - q) * (1.0f + q)) * to_c;
  // Then a point of that arc.
  const Vec3f chord = on_side - b_;
  const float drop = u.y * 0.5f * dot(chord, chord);  // 1 - cos of the angle from b
  const Vec3f across = on_side - dot(on_side, b_) * b_;
  const float width2 = dot(across, across);
  Vec3f direction = (1.0f - drop) * b_;
  if (width2 > 0.0f)
    direction = direction + (root(drop * (2.0f - drop)) / std::sqrt(width2)) * across;
  // Where that direction meets the plane of the triangle.
  const Vec3f normal = cross(direction, edge2_);
  const float determinant = dot(edge1_, normal);
  if (determinant == 0.0f) return {1.0f / 3, 1.0f / 3};
  const float x = std::clamp(-dot(corner_, normal) / determinant, 0.0f, 1.0f);
  const float y = -dot(direction, cross(corner_, edge1_)) / determinant;
  return {x, std::clamp(y, 0.0f, 1.0f - x)};
}

SeenRectangle::SeenRectangle(const Vec3f& corner, const Vec3f& edge1, const Vec3f& edge2) {
  x0_ = x1_ = y0_ = y1_ = z0_ = 0.0f;
  if (is_far(corner, edge1, edge2)) return;
  const float width = length(edge1), height = length(edge2);
  const Vec3f x = edge1 / width, y = edge2 / height;
  x0_ = dot(corner, x), x1_ = x0_ + width;
  y0_ = dot(corner, y), y1_ = y0_ + height;
  z0_ = -std::fabs(dot(corner, cross(x, y)));
  if (!(z0_ < 0.0f)) return;
  // The z of the normals of the four planes through the sides and the point of view.
  const auto slope = [&](float side) { return side / std::sqrt(z0_ * z0_ + side * side); };
  const float n0 = -slope(y0_), n1 = slope(x1_), n2 = slope(y1_), n3 = -slope(x0_);
  const float g0 = fast_acos(-n0 * n1), g1 = fast_acos(-n1 * n2);
  const float g2 = fast_acos(-n2 * n3), g3 = fast_acos(-n3 * n0);
  b0_ = n0, b1_ = n2;
  k_ = 2.0f * kPi - g2 - g3;
  solid_angle_ = usable(g0 + g1 - k_);
}

Vec2f SeenRectangle::sample(Vec2f u) const {
  const SinCos<float> angle = sin_cos(u.x * solid_angle_ + k_);
  const float f = (angle.cos * b0_ - b1_) / angle.sin;
  const float c = std::clamp(std::copysign(1.0f, f) / std::sqrt(f * f + b0_ * b0_), -1.0f, 1.0f);
  const float sine = root((1.0f - c) * (1.0f + c));
  const float x = std::clamp(sine > 0.0f ? -c * z0_ / sine : (c > 0.0f ? x1_ : x0_), x0_, x1_);
  const float d2 = x * x + z0_ * z0_, d = std::sqrt(d2);
  const float h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const float h = h0 + u.y * (h1 - h0);
  const float rest = (1.0f - h) * (1.0f + h);
  const float y = std::clamp(rest > 1e-6f ? h * d / std::sqrt(rest) : y1_, y0_, y1_);
  return {std::clamp((x - x0_) / (x1_ - x0_), 0.0f, 1.0f),
          std::clamp((y - y0_) / (y1_ - y0_), 0.0f, 1.0f)};
}

}  // namespace dapple
