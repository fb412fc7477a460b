// What double precision says of one ray and one shape: the referee when two structures disagree.
#pragma once

#include "kernels/tracer.h"

namespace dapple::bench {

enum class Verdict {
  hit,
  miss,
  borderline,  // within the error of single precision of a silhouette or an end of the ray
};

struct ExactHit {
  Verdict verdict = Verdict::miss;
  double t = 0;      // of the nearest hit in the ray's range
  double error = 0;  // how far from `t` single precision may be
};

[[nodiscard]] ExactHit exact_hit(const SceneView& scene, const Ray& ray, PrimId prim);

}  // namespace dapple::bench
