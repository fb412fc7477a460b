#include "tests/reference/reference_tracer.h"

#include <cmath>

#include "tests/reference/reference_materials.h"

namespace dapple::test {
namespace {

Triple triple(const Vec3d& v) { return {v.x, v.y, v.z}; }

// The picture plane at the focus distance, from its lower left corner.
struct Lens {
  Triple eye, corner, across, upwards;
  Triple right, up;  // unit
  double radius;

  Lens(const Camera& camera, double aspect) {
    const double pi = std::acos(-1.0);
    const double half_height = std::tan(camera.vertical_fov / 360 * pi);
    const double half_width = aspect * half_height;
    const Triple back = unit(triple(camera.look_from) - triple(camera.look_at));
    const double distance = camera.focus_distance;
    right = unit(outer(triple(camera.up), back));
    up = outer(back, right);
    eye = triple(camera.look_from);
    corner = eye - half_width * distance * right - half_height * distance * up - distance * back;
    across = 2 * half_width * distance * right;
    upwards = 2 * half_height * distance * up;
    radius = camera.aperture / 2;
  }

  // The ray to the point (s, t) of the picture, from (0, 0) lower left to (1, 1) upper right.
  ReferenceRay ray(double s, double t, ReferenceRandom& random) const {
    const Triple disc = radius * random_in_disc(random);
    const Triple from = eye + disc.x * right + disc.y * up;
    return {from, corner + s * across + t * upwards - from};
  }
};

class Tracer {
 public:
  Tracer(const Scene& scene, const ReferenceSettings& settings)
      : objects_(scene), settings_(settings) {}

  Triple colour(const ReferenceRay& ray, int scatterings, ReferenceRandom& random) const {
    if (scatterings == settings_.most_scatterings) return settings_.cut;
    const auto hit = objects_.nearest(ray);
    if (!hit) return sky(ray.direction);
    const auto scattered = scatter_reference(*hit, ray.direction, random);
    if (!scattered) return {0, 0, 0};
    return times(scattered->attenuation,
                 colour({hit->place, scattered->direction}, scatterings + 1, random));
  }

 private:
  Triple sky(const Triple& direction) const {
    const double t = (unit(direction).y + 1) / 2;
    return (1 - t) * settings_.sky_below + t * settings_.sky_above;
  }

  ReferenceObjects objects_;
  const ReferenceSettings& settings_;
};

}  // namespace

PictureStatistics reference_picture(const Scene& scene, const ReferenceSettings& settings) {
  const int nx = settings.width, ny = settings.height;
  const Lens lens(scene.camera, double(nx) / ny);
  const Tracer tracer(scene, settings);
  ReferenceRandom random(settings.seed);
  PictureStatistics picture(nx, ny);
  for (int j = 0; j < ny; ++j) {  // upwards
    for (int i = 0; i < nx; ++i) {
      const auto pixel = static_cast<std::size_t>((ny - 1 - j) * nx + i);
      for (int s = 0; s < settings.samples; ++s) {
        const double u = (i + random_number(random)) / nx;
        const double v = (j + random_number(random)) / ny;
        const Triple c = tracer.colour(lens.ray(u, v, random), 0, random);
        picture.add(pixel, {c.x, c.y, c.z});
      }
    }
  }
  picture.set_sample_count(settings.samples);
  return picture;
}

}  // namespace dapple::test
