// Two-component vectors: texture coordinates.
#pragma once

namespace dapple {

struct Vec2f {
  float x = 0, y = 0;
  friend constexpr bool operator==(const Vec2f&, const Vec2f&) = default;
};

constexpr Vec2f operator+(Vec2f a, Vec2f b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2f operator-(Vec2f a, Vec2f b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2f operator*(float s, Vec2f a) { return {s * a.x, s * a.y}; }

}  // namespace dapple
