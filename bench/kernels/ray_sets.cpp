#include "kernels/ray_sets.h"

#include <algorithm>

#include "kernels/surface.h"
#include "math/random.h"
#include "math/warps.h"
#include "render/camera_rays.h"

namespace dapple::bench {
namespace {

constexpr std::uint64_t kSeed = 0x64617070'6c650002u;
constexpr std::uint32_t kMaxPasses = 512;
constexpr std::uint32_t kBounces = 4;

// What each block of four random numbers is for.
enum Purpose : std::uint32_t { kCamera = 0, kShadow = 1, kShuffle = 2, kBounce = 16 };

std::array<float, 4> random4(std::size_t index, std::uint32_t pass, std::uint32_t purpose) {
  return uniform4(static_cast<std::uint32_t>(index), 0, pass, purpose, kSeed);
}

// Calls visit(x, y) for the pixels of [x0, x1) x [y0, y1) in blocks of `side`, each in turn
// visited in blocks of `inner`.
template <class Visit>
void for_each_block(int x0, int y0, int x1, int y1, int side, const Visit& visit) {
  for (int y = y0; y < y1; y += side) {
    for (int x = x0; x < x1; x += side) {
      visit(x, y, std::min(x + side, x1), std::min(y + side, y1));
    }
  }
}

std::vector<Ray> camera_rays(const CameraRays& camera, int side, std::uint32_t pass) {
  std::vector<Ray> rays;
  const auto pixel = [&](int x, int y, int, int) {
    rays.push_back(camera.generate(x, y, random4(rays.size(), pass, kCamera)));
  };
  const auto block = [&](int x0, int y0, int x1, int y1) {
    for_each_block(x0, y0, x1, y1, 1, pixel);
  };
  for_each_block(0, 0, side, side, 32,
                 [&](int x0, int y0, int x1, int y1) { for_each_block(x0, y0, x1, y1, 4, block); });
  return rays;
}

// From the surface to a point of the scene's box, stretched upwards by half its height and a
// tenth of its width; nothing when the point is behind the surface.
void add_shadow_ray(const Surface& at, const Bounds3f& box, const std::array<float, 4>& u,
                    std::vector<Ray>& rays) {
  const Vec3f size = box.hi - box.lo;
  const Vec3f stretched(size.x, 1.5f * size.y + 0.1f * size.x, size.z);
  const Vec3f target = box.lo + Vec3f(u[0] * stretched.x, u[1] * stretched.y, u[2] * stretched.z);
  const Vec3f to_target = target - at.position;
  const float distance = length(to_target);
  if (!(dot(to_target, at.normal) > 0.0f) || !(distance > 2 * kRayTMin)) return;
  rays.push_back({at.position, kRayTMin, to_target / distance, distance * (1 - 1e-3f)});
}

void shuffle_and_cut(std::size_t max_count, RaySet& set) {
  std::vector<Ray>& rays = set.rays;
  for (std::size_t i = rays.size(); i > 1; --i) {
    const std::uint64_t word =
        philox4x32({static_cast<std::uint32_t>(i), 0, 0, kShuffle}, kSeed)[0];
    std::swap(rays[i - 1], rays[(word * i) >> 32]);
  }
  rays.resize(std::min(rays.size(), max_count));
  rays.shrink_to_fit();
}

void cut(std::size_t max_count, RaySet& set) {
  set.rays.resize(std::min(set.rays.size(), max_count));
  set.rays.shrink_to_fit();
}

void append(const std::vector<Ray>& from, RaySet& to) {
  to.rays.insert(to.rays.end(), from.begin(), from.end());
}

// The paths of one pass over the picture, one generation of rays after the other.
class Pass {
 public:
  Pass(const SceneView& scene, const Bounds3f& box, const FindHits& find_hits, std::uint32_t number)
      : scene_(scene), box_(box), find_hits_(find_hits), number_(number) {}

  std::vector<Ray> rays;         // of the generation in hand
  std::vector<Ray> shadow_rays;  // from what the generation before hit

  // Replaces the rays by those that leave what they hit.
  void bounce(std::uint32_t generation) {
    const std::vector<Found> found = find_hits_(rays);
    std::vector<Ray> next;
    shadow_rays.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!found[i].hit()) continue;
      const Surface at = surface_at(scene_, rays[i], found[i]);
      const auto u = random4(i, number_, kBounce + generation);
      next.push_back({at.position, kRayTMin, sample_cosine_hemisphere(at.normal, u[0], u[1])});
      add_shadow_ray(at, box_, random4(i, number_, kShadow), shadow_rays);
    }
    rays = std::move(next);
  }

 private:
  const SceneView& scene_;
  const Bounds3f& box_;
  const FindHits& find_hits_;
  std::uint32_t number_;
};

}  // namespace

Expected<std::vector<RaySet>> make_ray_sets(const SceneView& scene, int image_side,
                                            const FindHits& find_hits) {
  RenderSettings settings;
  settings.width = settings.height = image_side;
  const auto camera = CameraRays::create(scene.camera, settings);
  if (!camera) return tl::unexpected(camera.error());
  const std::size_t count = static_cast<std::size_t>(image_side) * image_side;
  const Bounds3f box = scene_bounds(scene);

  std::vector<RaySet> sets = {{"primary", Query::closest, camera_rays(*camera, image_side, 0)},
                              {"diffuse 1", Query::closest, {}},
                              {"diffuse 4", Query::closest, {}},
                              {"shadow", Query::any, {}}};
  RaySet &diffuse1 = sets[1], &diffuse4 = sets[2], &shadow = sets[3];
  for (std::uint32_t number = 0; number < kMaxPasses && diffuse4.rays.size() < count; ++number) {
    Pass pass(scene, box, find_hits, number);
    pass.rays = camera_rays(*camera, image_side, number);
    for (std::uint32_t bounce = 1; bounce <= kBounces; ++bounce) {
      pass.bounce(bounce);
      if (bounce > 1) continue;
      if (pass.rays.empty()) return fail(Errc::bad_data, "scene", "the camera sees no surface");
      if (diffuse1.rays.size() < count) append(pass.rays, diffuse1);
      if (shadow.rays.size() < count) append(pass.shadow_rays, shadow);
    }
    append(pass.rays, diffuse4);
  }
  shuffle_and_cut(count, diffuse1);
  shuffle_and_cut(count, diffuse4);
  cut(count, shadow);
  return sets;
}

}  // namespace dapple::bench
