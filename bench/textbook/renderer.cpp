#include "textbook/renderer.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "parallel/parallel.h"
#include "textbook/scatter.h"

namespace dapple::textbook {
namespace {

class LensCamera {
 public:
  LensCamera(const Camera& camera, const RenderSettings& settings)
      : origin_(camera.look_from), lens_radius_(camera.aperture / 2) {
    const double half_angle = camera.vertical_fov * std::numbers::pi / 360;
    const double half_height = std::tan(half_angle) * camera.focus_distance;
    const double half_width = half_height * settings.width / settings.height;
    const Vec3d w = normalize(camera.look_from - camera.look_at);
    u_ = normalize(cross(camera.up, w));
    v_ = cross(w, u_);
    horizontal_ = 2 * half_width * u_;
    vertical_ = 2 * half_height * v_;
    corner_ = origin_ - half_width * u_ - half_height * v_ - camera.focus_distance * w;
  }

  // s and t run from 0 to 1, left to right and bottom to top.
  Ray ray(double s, double t, Random& random) const {
    const Vec3d lens = lens_radius_ * random_in_unit_disc(random);
    const Vec3d start = origin_ + lens.x * u_ + lens.y * v_;
    return {start, corner_ + s * horizontal_ + t * vertical_ - start};
  }

 private:
  Vec3d origin_, corner_, horizontal_, vertical_, u_, v_;
  double lens_radius_;
};

Vec3d sky(const Vec3d& direction) {
  const double t = (normalize(direction).y + 1) / 2;
  return (1 - t) * Vec3d(1, 1, 1) + t * Vec3d(0.5, 0.7, 1);
}

Vec3d ray_colour(const World& world, const Ray& ray, int scatterings_left, Random& random,
                 std::uint64_t& ray_count) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (scatterings_left == 0) return {1, 1, 1};
  ++ray_count;
  HitRecord record;
  if (!world.hit(ray, 1e-3, kInfinity, record)) return sky(ray.direction);
  const auto scattered = scatter(record, ray.direction, random);
  if (!scattered) return {0, 0, 0};
  return scattered->attenuation * ray_colour(world, {record.point, scattered->direction},
                                             scatterings_left - 1, random, ray_count);
}

}  // namespace

Picture render(const World& world, const Camera& camera, const RenderSettings& settings) {
  const LensCamera lens(camera, settings);
  const int width = settings.width, height = settings.height;
  Picture picture{Image(width, height), 0};
  std::atomic<std::uint64_t> total_rays{0};

  parallel_for_dynamic(static_cast<std::size_t>(height), [&](std::size_t row) {
    Random random(settings.seed * 0x10000000u + row * 0x9e3779b9u + 1);
    std::uint64_t ray_count = 0;
    for (int x = 0; x < width; ++x) {
      Vec3d sum;
      for (int sample = 0; sample < settings.samples_per_pixel; ++sample) {
        const double s = (x + random.next()) / width;
        const double t = 1 - (static_cast<double>(row) + random.next()) / height;
        const Ray ray = lens.ray(s, t, random);
        sum = sum + ray_colour(world, ray, settings.max_scatterings, random, ray_count);
      }
      const Vec3d mean = sum / static_cast<double>(settings.samples_per_pixel);
      picture.image.pixels[row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
          Vec3f(mean);
    }
    total_rays += ray_count;
  });
  picture.ray_count = total_rays;
  return picture;
}

}  // namespace dapple::textbook
