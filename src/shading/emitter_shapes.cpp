#include "shading/emitter_shapes.h"

#include <algorithm>
#include <cmath>

#include "math/fast_functions.h"
#include "math/frame.h"
#include "math/warps.h"

namespace dapple {
namespace {

struct Ball {
  Vec3f centre;
  float radius;
};

Ball ball_of(const Sphere& sphere) {
  return {Vec3f(sphere.centre), static_cast<float>(std::fabs(sphere.radius))};
}

// 1 - cos of the half angle of the cone that a sphere fills, for radius^2 / distance^2 below 1:
// without the cancellation for small ones.
float one_minus_cosine(float sin2) {
  return sin2 < 1e-3f ? sin2 * (0.5f + 0.125f * sin2)
                      : 1.0f - std::sqrt(std::max(1.0f - sin2, 0.0f));
}

bool cone_applies(float radius, float distance2) { return distance2 > radius * radius * 1.0001f; }

struct Rod {
  Vec3f begin, axis;  // unit axis
  float length, radius;
  float side_area() const { return 2.0f * kPi * radius * length; }
  float cap_area() const { return kPi * radius * radius; }
};

Rod rod_of(const Cylinder& cylinder) {
  const Vec3d along = cylinder.end - cylinder.begin;
  const double l = length(along);
  return {Vec3f(cylinder.begin), l > 0 ? Vec3f(along / l) : Vec3f(0, 0, 1), static_cast<float>(l),
          static_cast<float>(std::fabs(cylinder.radius))};
}

void set_rod_point(const Rod& rod, Vec2f u, SurfaceInteraction& at) {
  const Frame frame = frame_around(rod.axis);
  const SinCos<float> around = sin_cos_turns(u.y);
  const Vec3f outward = around.cos * frame.tangent + around.sin * frame.bitangent;
  const float total = rod.side_area() + 2.0f * rod.cap_area();
  const float x = u.x * total;
  if (x < rod.side_area()) {
    at.position = rod.begin + (rod.length * x / rod.side_area()) * rod.axis + rod.radius * outward;
    at.geometric_normal = outward;
    return;
  }
  const float in_caps = (x - rod.side_area()) / rod.cap_area();
  const bool far = in_caps >= 1.0f;
  const float r = rod.radius * std::sqrt(std::clamp(far ? in_caps - 1.0f : in_caps, 0.0f, 1.0f));
  at.position = rod.begin + (far ? rod.length : 0.0f) * rod.axis + r * outward;
  at.geometric_normal = far ? rod.axis : -rod.axis;
}

// As surfaces that rays hit have them.
void set_sphere_uvs(SurfaceInteraction& at) {
  const Vec3f& n = at.geometric_normal;
  at.uvs[0] = at.uvs[1] = {fast_atan2(n.z, n.x) * (0.5f * kInvPi) + 0.5f, fast_acos(n.y) * kInvPi};
}

}  // namespace

MaterialId EmitterShapes::material(const EmitterId& emitter) const {
  switch (emitter.kind) {
    case EmitterKind::triangle:
      return scene_.triangle_materials[emitter.index];
    case EmitterKind::sphere:
      return scene_.sphere_materials[emitter.index];
    case EmitterKind::cylinder:
      return scene_.cylinder_materials[emitter.index];
    default:
      break;
  }
  const auto kind =
      static_cast<std::size_t>(emitter.kind) - static_cast<std::size_t>(EmitterKind::xy_rectangle);
  return scene_.rectangle_materials[kind][emitter.index];
}

// Uniform over the shape's area.
SurfaceInteraction EmitterShapes::point_of(const EmitterId& emitter, Vec2f u) const {
  if (emitter.kind == EmitterKind::triangle) {
    const float root = std::sqrt(u.x);
    return flat_point(emitter, triangle_corners(emitter), {1.0f - root, u.y * root});
  }
  if (is_rectangle(emitter.kind)) return flat_point(emitter, rectangle_corners(emitter), u);
  SurfaceInteraction at;
  if (emitter.kind == EmitterKind::sphere) {
    const Ball ball = ball_of(scene_.spheres[emitter.index]);
    at.geometric_normal = sample_uniform_sphere(u.x, u.y);
    at.position = ball.centre + ball.radius * at.geometric_normal;
    set_sphere_uvs(at);
  } else {
    set_rod_point(rod_of(scene_.cylinders[emitter.index]), u, at);
  }
  const float squared = dot(at.geometric_normal, at.geometric_normal);
  if (squared > 0.0f) at.geometric_normal = at.geometric_normal / std::sqrt(squared);
  return at;
}

float EmitterShapes::area(const EmitterId& emitter) const {
  if (emitter.kind == EmitterKind::triangle) {
    const Corners c = triangle_corners(emitter);
    return 0.5f * length(cross(c.edge1, c.edge2));
  }
  if (emitter.kind == EmitterKind::sphere) {
    const float r = ball_of(scene_.spheres[emitter.index]).radius;
    return 4.0f * kPi * r * r;
  }
  if (emitter.kind == EmitterKind::cylinder) {
    const Rod rod = rod_of(scene_.cylinders[emitter.index]);
    return rod.side_area() + 2.0f * rod.cap_area();
  }
  const Corners c = rectangle_corners(emitter);
  return length(c.edge1) * length(c.edge2);
}

std::optional<EmitterPoint> EmitterShapes::sample(const EmitterId& emitter, const Vec3f& position,
                                                  Vec2f u) const {
  if (emitter.kind == EmitterKind::sphere) {
    if (auto found = sample_sphere(emitter, position, u)) return found;
  }
  EmitterPoint result;
  const bool seen = sample_seen(emitter, position, u, result);
  if (!seen) result.surface = point_of(emitter, u);
  const Vec3f to_light = result.surface.position - position;
  const float squared = dot(to_light, to_light);
  if (!(squared > 0.0f)) return std::nullopt;
  result.distance = std::sqrt(squared);
  result.wi = to_light / result.distance;
  if (!seen) {
    result.pdf = area_pdf(emitter, result.wi, result.distance, result.surface.geometric_normal);
  }
  if (!(result.pdf > 0.0f)) return std::nullopt;
  return result;
}

// A direction of the cone that the sphere fills, and the nearer point of the sphere along it.
std::optional<EmitterPoint> EmitterShapes::sample_sphere(const EmitterId& emitter,
                                                         const Vec3f& position, Vec2f u) const {
  const Ball ball = ball_of(scene_.spheres[emitter.index]);
  const Vec3f to_centre = ball.centre - position;
  const float distance2 = dot(to_centre, to_centre);
  if (!cone_applies(ball.radius, distance2)) return std::nullopt;
  const float distance = std::sqrt(distance2);
  const float height = one_minus_cosine(ball.radius * ball.radius / distance2);
  const float below = u.x * height;  // 1 - cos of the angle to the axis
  const float sin2 = below * (2.0f - below), cosine = 1.0f - below;
  const SinCos<float> around = sin_cos_turns(u.y);
  const float sine = std::sqrt(sin2);
  const Vec3f axis = to_centre / distance;
  EmitterPoint result;
  result.wi = frame_around(axis).to_world({sine * around.cos, sine * around.sin, cosine});
  const float half_chord2 = ball.radius * ball.radius - distance2 * sin2;
  result.distance = distance * cosine - std::sqrt(std::max(half_chord2, 0.0f));
  result.pdf = 1.0f / (2.0f * kPi * height);
  result.surface.position = position + result.distance * result.wi;
  const Vec3f outward = result.surface.position - ball.centre;
  const float squared = dot(outward, outward);
  result.surface.geometric_normal = squared > 0.0f ? outward / std::sqrt(squared) : -axis;
  set_sphere_uvs(result.surface);
  return result;
}

float EmitterShapes::pdf(const EmitterId& emitter, const Vec3f& position, const Vec3f& wi,
                         float distance, const Vec3f& normal) const {
  if (emitter.kind == EmitterKind::sphere) {
    const Ball ball = ball_of(scene_.spheres[emitter.index]);
    const Vec3f to_centre = ball.centre - position;
    const float distance2 = dot(to_centre, to_centre);
    if (cone_applies(ball.radius, distance2)) {
      return 1.0f / (2.0f * kPi * one_minus_cosine(ball.radius * ball.radius / distance2));
    }
  }
  const float seen = solid_angle(emitter, position);
  return seen > 0.0f ? 1.0f / seen : area_pdf(emitter, wi, distance, normal);
}

float EmitterShapes::area_pdf(const EmitterId& emitter, const Vec3f& wi, float distance,
                              const Vec3f& normal) const {
  const float projected = std::fabs(dot(wi, normal)) * area(emitter);
  return projected > 1e-30f ? distance * distance / projected : 0.0f;
}

SurfaceInteraction EmitterShapes::middle(const EmitterId& emitter) const {
  // The corner where the warp of triangles has its centroid.
  SurfaceInteraction at = point_of(emitter, {4.0f / 9, 0.5f});
  at.cone_width = std::sqrt(area(emitter));
  at.uv_per_length = {1.0f / at.cone_width, 1.0f / at.cone_width};
  if (emitter.kind != EmitterKind::triangle) return at;
  const auto& v = scene_.triangles[emitter.index].vertices;
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    const auto& uvs = scene_.vertices.uvs[set];
    if (uvs.empty()) continue;
    const Vec2f a = uvs[v[1]] - uvs[v[0]], b = uvs[v[2]] - uvs[v[0]];
    at.uv_per_length[set] = std::sqrt(0.5f * std::fabs(a.x * b.y - a.y * b.x)) / at.cone_width;
  }
  return at;
}

LightBounds EmitterShapes::bounds(const EmitterId& emitter) const {
  LightBounds result;
  result.power = area(emitter);
  const auto add = [&](const Vec3f& p) { result.bounds.extend({p, p}); };
  if (emitter.kind == EmitterKind::sphere) {
    const Ball ball = ball_of(scene_.spheres[emitter.index]);
    const Vec3f r(ball.radius, ball.radius, ball.radius);
    add(ball.centre - r);
    add(ball.centre + r);
    result.cos_spread = 0;
    result.power *= 0.25f;  // the area that is seen from anywhere
    return result;
  }
  if (emitter.kind == EmitterKind::cylinder) {
    const Rod rod = rod_of(scene_.cylinders[emitter.index]);
    const Vec3f r(rod.radius, rod.radius, rod.radius), end = rod.begin + rod.length * rod.axis;
    add(rod.begin - r);
    add(rod.begin + r);
    add(end - r);
    add(end + r);
    result.cos_spread = 0;
    result.power *= 0.25f;
    return result;
  }
  const bool triangle = emitter.kind == EmitterKind::triangle;
  const Corners c = triangle ? triangle_corners(emitter) : rectangle_corners(emitter);
  add(c.origin);
  add(c.origin + c.edge1);
  add(c.origin + c.edge2);
  if (!triangle) add(c.origin + c.edge1 + c.edge2);
  const Vec3f n = cross(c.edge1, c.edge2);
  const float squared = dot(n, n);
  if (squared > 0.0f) result.axis = n / std::sqrt(squared);
  return result;
}

}  // namespace dapple
