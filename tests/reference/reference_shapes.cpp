#include "tests/reference/reference_shapes.h"

#include <limits>

namespace dapple::test {
namespace {

constexpr double kNearest = 1e-3;
constexpr double kNever = std::numeric_limits<double>::infinity();

double part(const Triple& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

ReferenceObjects::ReferenceObjects(const Scene& scene) {
  const auto material = [&](MaterialId id) {
    return &scene.materials[static_cast<std::size_t>(id)];
  };
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const Sphere& s = scene.spheres[i];
    balls_.push_back(
        {{s.centre.x, s.centre.y, s.centre.z}, s.radius, material(scene.sphere_materials[i])});
  }
  // The rectangle kinds stand in the order xy, xz, yz: flat along z, y, x.
  for (std::size_t kind = 0; kind < 3; ++kind) {
    for (std::size_t i = 0; i < scene.rectangles[kind].size(); ++i) {
      const Rectangle& r = scene.rectangles[kind][i];
      const Material* m = material(scene.rectangle_materials[kind][i]);
      if (kind == 0) plates_.push_back({{r.u0, r.v0, r.k}, {r.u1, r.v1, r.k}, 2, m});
      if (kind == 1) plates_.push_back({{r.u0, r.k, r.v0}, {r.u1, r.k, r.v1}, 1, m});
      if (kind == 2) plates_.push_back({{r.k, r.u0, r.v0}, {r.k, r.u1, r.v1}, 0, m});
    }
  }
}

// The smaller root of |o + t d - c|^2 = r^2 that is not too near.
double ReferenceObjects::meet(const Ball& ball, const ReferenceRay& ray) {
  const Triple from_centre = ray.origin - ball.centre;
  const double a = inner(ray.direction, ray.direction);
  const double b = 2 * inner(from_centre, ray.direction);
  const double c = inner(from_centre, from_centre) - ball.radius * ball.radius;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant <= 0) return kNever;
  const double root = std::sqrt(discriminant);
  const double first = (-b - root) / (2 * a), second = (-b + root) / (2 * a);
  if (first > kNearest) return first;
  return second > kNearest ? second : kNever;
}

double ReferenceObjects::meet(const Plate& plate, const ReferenceRay& ray) {
  const int flat = plate.flat_axis;
  const double t = (plate.low[flat] - part(ray.origin, flat)) / part(ray.direction, flat);
  if (!(t > kNearest && t < kNever)) return kNever;
  const Triple place = ray.origin + t * ray.direction;
  for (int axis = 0; axis < 3; ++axis) {
    const double p = part(place, axis);
    if (axis != flat && (p < plate.low[axis] || p > plate.high[axis])) return kNever;
  }
  return t;
}

std::optional<ReferenceHit> ReferenceObjects::nearest(const ReferenceRay& ray) const {
  double best = kNever;
  const Ball* ball = nullptr;
  const Plate* plate = nullptr;
  for (const Ball& candidate : balls_) {
    const double t = meet(candidate, ray);
    if (t < best) best = t, ball = &candidate;
  }
  for (const Plate& candidate : plates_) {
    const double t = meet(candidate, ray);
    if (t < best) best = t, plate = &candidate;
  }
  if (best == kNever) return std::nullopt;
  const Triple place = ray.origin + best * ray.direction;
  if (plate == nullptr) {
    // Dividing by the signed radius turns the normal of an inside-out sphere inwards.
    return ReferenceHit{best, place, (1 / ball->radius) * (place - ball->centre), ball->material};
  }
  const int flat = plate->flat_axis;
  const Triple outward = {flat == 0 ? 1.0 : 0.0, flat == 1 ? 1.0 : 0.0, flat == 2 ? 1.0 : 0.0};
  return ReferenceHit{best, place, outward, plate->material};
}

}  // namespace dapple::test
