// Spheres and rectangles of the reference tracer, in double precision, by the plain formulas.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "tests/reference/triple.h"

namespace dapple::test {

struct ReferenceRay {
  Triple origin;
  Triple direction;
};

struct ReferenceHit {
  double t = 0;
  Triple place;
  Triple outward;  // unit
  const Material* material = nullptr;
};

// Every object is tested against every ray.
class ReferenceObjects {
 public:
  explicit ReferenceObjects(const Scene& scene);

  // The nearest hit with t > 1e-3.
  std::optional<ReferenceHit> nearest(const ReferenceRay& ray) const;

 private:
  struct Ball {
    Triple centre;
    double radius;
    const Material* material;
  };
  struct Plate {
    double low[3], high[3];  // low == high along the axis it is flat in
    int flat_axis;
    const Material* material;
  };

  static double meet(const Ball& ball, const ReferenceRay& ray);
  static double meet(const Plate& plate, const ReferenceRay& ray);

  std::vector<Ball> balls_;
  std::vector<Plate> plates_;
};

}  // namespace dapple::test
