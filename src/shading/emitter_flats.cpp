// Emitters that are triangles or rectangles.
#include <cmath>

#include "shading/emitter_shapes.h"
#include "shading/solid_angle.h"

namespace dapple {
namespace {

Vec3f normalised(const Vec3f& n) {
  const float squared = dot(n, n);
  return squared > 0.0f ? n / std::sqrt(squared) : n;
}

}  // namespace

EmitterShapes::Corners EmitterShapes::triangle_corners(const EmitterId& emitter) const {
  const Triangle& triangle = scene_.triangles[emitter.index];
  std::array<Vec3f, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = scene_.vertices.positions[triangle.vertices[i]];
    if (emitter.instance != kNoInstance) {
      p[i] = scene_.instances[emitter.instance].to_world.point(p[i]);
    }
  }
  return {p[0], p[1] - p[0], p[2] - p[0]};
}

EmitterShapes::Corners EmitterShapes::rectangle_corners(const EmitterId& emitter) const {
  const auto index =
      static_cast<std::size_t>(emitter.kind) - static_cast<std::size_t>(EmitterKind::xy_rectangle);
  const Rectangle& r = scene_.rectangles[index][emitter.index];
  const RectangleAxes axes = rectangle_axes(rectangle_kind(index));
  Corners c;
  c.origin[axes.u] = static_cast<float>(r.u0);
  c.origin[axes.v] = static_cast<float>(r.v0);
  c.origin[axes.k] = static_cast<float>(r.k);
  c.edge1[axes.u] = static_cast<float>(r.u1 - r.u0);
  c.edge2[axes.v] = static_cast<float>(r.v1 - r.v0);
  return c;
}

void EmitterShapes::set_triangle_uvs(const EmitterId& emitter, float b1, float b2,
                                     SurfaceInteraction& at) const {
  const auto& v = scene_.triangles[emitter.index].vertices;
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    const auto& uvs = scene_.vertices.uvs[set];
    if (uvs.empty()) continue;
    at.uvs[set] = (1.0f - b1 - b2) * uvs[v[0]] + b1 * uvs[v[1]] + b2 * uvs[v[2]];
  }
}

// A point of a triangle or rectangle, by factors of the two edges.
SurfaceInteraction EmitterShapes::flat_point(const EmitterId& emitter, const Corners& c,
                                             Vec2f along) const {
  SurfaceInteraction at;
  at.position = c.origin + along.x * c.edge1 + along.y * c.edge2;
  at.geometric_normal = normalised(cross(c.edge1, c.edge2));
  if (emitter.kind == EmitterKind::triangle) {
    set_triangle_uvs(emitter, along.x, along.y, at);
  } else {
    at.uvs[0] = at.uvs[1] = {along.x, 1.0f - along.y};
  }
  return at;
}

// By the solid angle, where that helps: sets surface and density.
bool EmitterShapes::sample_seen(const EmitterId& emitter, const Vec3f& position, Vec2f u,
                                EmitterPoint& result) const {
  const auto by = [&](const Corners& c, const auto& seen) {
    if (!(seen.solid_angle() > 0.0f)) return false;
    result.surface = flat_point(emitter, c, seen.sample(u));
    result.pdf = 1.0f / seen.solid_angle();
    return true;
  };
  if (emitter.kind == EmitterKind::triangle) {
    const Corners c = triangle_corners(emitter);
    return by(c, SeenTriangle(c.origin - position, c.edge1, c.edge2));
  }
  if (!is_rectangle(emitter.kind)) return false;
  const Corners c = rectangle_corners(emitter);
  return by(c, SeenRectangle(c.origin - position, c.edge1, c.edge2));
}

float EmitterShapes::solid_angle(const EmitterId& emitter, const Vec3f& position) const {
  if (emitter.kind == EmitterKind::triangle) {
    const Corners c = triangle_corners(emitter);
    return SeenTriangle(c.origin - position, c.edge1, c.edge2).solid_angle();
  }
  if (!is_rectangle(emitter.kind)) return 0.0f;
  const Corners c = rectangle_corners(emitter);
  return SeenRectangle(c.origin - position, c.edge1, c.edge2).solid_angle();
}

}  // namespace dapple
