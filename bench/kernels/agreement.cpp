#include "kernels/agreement.h"

#include <cmath>

#include "kernels/exact_hit.h"

namespace dapple::bench {
namespace {

// Relative difference of distances that counts as the same without asking the referee.
constexpr float kSameDistance = 1e-5f;

bool same(const Found& a, const Found& b) {
  if (a.prim != b.prim) return false;
  return !a.hit() || std::fabs(a.t - b.t) <= kSameDistance * a.t;
}

// The same primitive at different distances.
void judge_distances(const ExactHit& exact, const Found& a, const Found& b, Agreement& result) {
  const auto wrong = [&](const Found& found) {
    return std::fabs(double{found.t} - exact.t) > exact.error;
  };
  if (exact.verdict == Verdict::borderline || (!wrong(a) && !wrong(b))) {
    ++result.borderline;
    return;
  }
  result.a_wrong += wrong(a);
  result.b_wrong += wrong(b);
}

void judge(const SceneView& scene, const Ray& ray, const Found& a, const Found& b,
           Agreement& result) {
  const ExactHit exact_a = a.hit() ? exact_hit(scene, ray, a.prim) : ExactHit{};
  const ExactHit exact_b = b.hit() ? exact_hit(scene, ray, b.prim) : ExactHit{};
  if (a.hit() && a.prim == b.prim) return judge_distances(exact_a, a, b, result);
  const bool unsure =
      exact_a.verdict == Verdict::borderline || exact_b.verdict == Verdict::borderline;
  const bool hit_a = exact_a.verdict == Verdict::hit, hit_b = exact_b.verdict == Verdict::hit;
  const bool tie =
      hit_a && hit_b && std::fabs(exact_a.t - exact_b.t) <= exact_a.error + exact_b.error;
  if (unsure || tie) {
    ++result.borderline;
  } else if (hit_a && (!hit_b || exact_a.t < exact_b.t)) {
    ++result.b_wrong;
  } else if (hit_b) {
    ++result.a_wrong;
  } else {  // both, or the only one that claims a hit, claim one that is not there
    result.a_wrong += a.hit();
    result.b_wrong += b.hit();
  }
}

}  // namespace

Agreement compare_closest(const SceneView& scene, std::span<const Ray> rays,
                          std::span<const Found> a, std::span<const Found> b) {
  Agreement result;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (same(a[i], b[i])) {
      ++result.same;
    } else {
      judge(scene, rays[i], a[i], b[i], result);
    }
  }
  return result;
}

Agreement compare_any(const SceneView& scene, std::span<const Ray> rays, std::span<const Found> a,
                      std::span<const Found> b, const FindHits& find_a, const FindHits& find_b) {
  std::vector<Ray> disputed;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (a[i].hit() == b[i].hit()) continue;
    disputed.push_back(rays[i]);
    places.push_back(i);
  }
  Agreement result;
  result.same = rays.size() - disputed.size();
  if (disputed.empty()) return result;
  const std::vector<Found> closest_a = find_a(disputed), closest_b = find_b(disputed);
  for (std::size_t i = 0; i < disputed.size(); ++i) {
    // Each side keeps to what its any-hit query said.
    const Found claim_a = a[places[i]].hit() ? closest_a[i] : Found{};
    const Found claim_b = b[places[i]].hit() ? closest_b[i] : Found{};
    judge(scene, disputed[i], claim_a, claim_b, result);
  }
  return result;
}

}  // namespace dapple::bench
