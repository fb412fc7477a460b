#include "tests/scenes/nasty_scenes.h"

#include <cmath>
#include <random>

#include "scene/validate.h"

namespace dapple::test {
namespace {

class Maker {
 public:
  Maker(const NastyConfig& config, std::uint64_t seed) : config_(config), random_(seed) {}

  Scene make() {
    material_ = scene_.add_material(Lambertian{{0.5, 0.5, 0.5}});
    const bool with_instances =
        config_.shapes == Shapes::everything || config_.shapes == Shapes::instances;
    const std::size_t instances = with_instances ? (config_.object_count + 2) / 3 : 0;
    for (std::size_t i = 0; i < config_.object_count - instances; ++i) add_object();
    if (instances > 0) add_prototypes();
    for (std::size_t i = 0; i < instances; ++i) add_instance();
    return scene_;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  double coordinate() {
    const double x = between(-1, 1);
    return config_.distance + config_.size * (config_.on_grid ? std::round(8 * x) / 8 : x);
  }
  // Mostly about a tenth of the scene; odd ones from nothing to larger than everything.
  double extent() {
    if (!odd_) {
      return config_.size * (config_.on_grid ? (1 + pick(2)) / 8.0 : between(0.02, 0.25));
    }
    const double factors[] = {0, 1e-30, 1e-6, 3, 1e3};
    return config_.size * factors[pick(5)];
  }

  void add_object() {
    odd_ = between(0, 1) < config_.odd_share;
    switch (config_.shapes) {
      case Shapes::spheres:
        return add_sphere();
      case Shapes::rectangles:
        return add_rectangle();
      case Shapes::mixture:
        return pick(2) == 0 ? add_sphere() : add_rectangle();
      case Shapes::triangles:
        return add_triangle();
      case Shapes::everything:
      case Shapes::instances:
        break;
    }
    const int kind = pick(5);
    if (kind == 0) return add_sphere();
    if (kind == 1) return add_rectangle();
    if (kind == 2) return add_cylinder();
    add_triangle();
  }

  void add_cylinder() {
    const Vec3d a(coordinate(), coordinate(), coordinate());
    Cylinder c{a, a + step(), 0.3 * extent()};
    if (odd_) {
      const int what = pick(4);
      if (what == 0) c.end = c.begin;
      if (what == 1) c.end = {a.x, a.y, a.z + extent()};  // along an axis
      if (what == 2 && !scene_.cylinders.empty()) c = scene_.cylinders.back();
    }
    scene_.add_cylinder(c, material_);
  }

  // Of triangles like those of the world.
  void add_prototypes() {
    for (const std::size_t count : {1u, 2u, 20u, 70u}) {
      Scene world = scene_;
      scene_.triangles.clear();
      scene_.triangle_materials.clear();
      for (std::size_t i = 0; i < count; ++i) {
        odd_ = between(0, 1) < config_.odd_share;
        add_triangle();
      }
      world.vertices = scene_.vertices;
      world.add_prototype(scene_.triangles, scene_.triangle_materials);
      scene_ = world;
    }
  }

  // Turned, scaled, sheared, mirrored, or nearly flat.
  void add_instance() {
    odd_ = between(0, 1) < config_.odd_share;
    Instance instance;
    instance.prototype = static_cast<std::uint32_t>(pick(4));
    auto& rows = instance.to_world.rows;
    const int what = odd_ ? pick(6) : 6;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const double size = i == j ? (pick(3) == 0 ? -1 : 1) * between(0.3, 1) : between(-0.3, 0.3);
        rows[i][j] = static_cast<float>(what == 0 ? (i == j) : what == 1 ? 1e-3 * size : size);
      }
      rows[i][3] = static_cast<float>(what == 0 ? 0 : config_.size * between(-1, 1));
    }
    if (what == 2) {
      for (float& number : rows[2]) number *= 1e-6f;
    }
    if (what == 4 && !scene_.instances.empty()) instance = scene_.instances.back();
    // The nearly flat may be too flat, or thrown too far by being turned back.
    if (is_valid(instance.to_world)) scene_.add_instance(instance);
  }

  std::uint32_t add_vertex(const Vec3d& at) {
    scene_.vertices.positions.push_back(Vec3f(at));
    return static_cast<std::uint32_t>(scene_.vertices.positions.size() - 1);
  }
  Vec3d step() {
    return {extent() * (pick(2) - 0.5), extent() * between(-1, 1), extent() * (pick(3) - 1)};
  }

  void add_triangle() {
    const Vec3d a(coordinate(), coordinate(), coordinate());
    const Vec3d b = a + step(), c = a + step();
    Triangle t{{add_vertex(a), add_vertex(b), add_vertex(c)}};
    if (!scene_.triangles.empty() && pick(2) == 0) {  // shares an edge, as in a mesh
      const Triangle& earlier = some_triangle();
      t.vertices[0] = earlier.vertices[1];
      t.vertices[1] = earlier.vertices[0];
    }
    if (odd_) {
      const int what = pick(5);
      if (what == 0) t.vertices[2] = t.vertices[1];  // a line, or a point
      if (what == 1) t.vertices[2] = add_vertex(0.5 * (a + b) + 1e-6 * step());  // a sliver
      if (what == 2 && !scene_.triangles.empty()) t = some_triangle();
      if (what == 3) t.vertices[2] = add_vertex(0.25 * a + 0.75 * b);
    }
    scene_.add_triangle(t, material_);
  }
  const Triangle& some_triangle() {
    const auto count = static_cast<int>(scene_.triangles.size());
    return scene_.triangles[static_cast<std::size_t>(pick(count))];
  }

  void add_sphere() {
    Sphere s{{coordinate(), coordinate(), coordinate()}, extent()};
    if (odd_ && !scene_.spheres.empty()) {
      const Sphere& earlier =
          scene_.spheres[static_cast<std::size_t>(pick(static_cast<int>(scene_.spheres.size())))];
      const int what = pick(5);
      if (what == 0) s = earlier;                                  // the same again
      if (what == 1) s = {earlier.centre, -0.9 * earlier.radius};  // a hollow in it
      if (what == 2) s.centre = earlier.centre;                    // concentric
    }
    scene_.add_sphere(s, material_);
  }

  void add_rectangle() {
    const auto index = static_cast<std::size_t>(pick(3));
    const double u = coordinate(), v = coordinate();
    Rectangle r{u, u + extent(), v, v + extent(), coordinate()};
    const auto& same_kind = scene_.rectangles[index];
    if (odd_) {
      const int what = pick(5);
      if (what == 0) std::swap(r.u0, r.u1);  // inside out: nothing can hit it
      if (what == 1 && !same_kind.empty()) {
        r = same_kind[static_cast<std::size_t>(pick(static_cast<int>(same_kind.size())))];
      }
      if (what == 2 && !same_kind.empty()) r.k = same_kind.back().k;  // in one plane, overlapping
    }
    scene_.add_rectangle(rectangle_kind(index), r, material_);
  }

  const NastyConfig& config_;
  std::mt19937_64 random_;
  Scene scene_;
  MaterialId material_{};
  bool odd_ = false;
};

class RayMaker {
 public:
  RayMaker(const Scene& scene, const NastyConfig& config, std::uint64_t seed)
      : scene_(scene), config_(config), random_(seed) {}

  Ray make() {
    Ray ray;
    const Vec3d origin = pick(4) == 0 ? point_of_object() : point(pick(2) == 0 ? 1 : 3);
    const Vec3d target = pick(3) == 0 ? point(1) : point_of_object();
    Vec3d direction = target - origin;
    if (pick(2) == 0) direction = (1 / std::fmax(length(direction), 1e-300)) * direction;
    ray.origin = Vec3f(origin);
    ray.direction = Vec3f(direction);
    flatten(ray.direction);
    bound(ray);
    return ray;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  Vec3d point(double spread) {
    Vec3d p;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = spread * between(-1, 1);
      p[axis] = config_.distance + config_.size * (config_.on_grid ? std::round(8 * x) / 8 : x);
    }
    return p;
  }

  // A point on, in or at the corner of the box of some object.
  Vec3d point_of_object() {
    if (!scene_.triangles.empty() && (scene_.runs.size() == 1 || pick(2) == 0)) {
      const Vec3d at = point_of_triangle();
      if (scene_.instances.empty() || pick(2) == 0) return at;
      const auto count = static_cast<int>(scene_.instances.size());
      return scene_.instances[static_cast<std::size_t>(pick(count))].to_world.point(at);
    }
    if (!scene_.cylinders.empty() && pick(3) == 0) {
      const auto count = static_cast<int>(scene_.cylinders.size());
      const Cylinder& c = scene_.cylinders[static_cast<std::size_t>(pick(count))];
      const Vec3d off(between(-1, 1), between(-1, 1), between(-1, 1));
      return c.begin + between(0, 1) * (c.end - c.begin) + c.radius * off;
    }
    const bool sphere = !scene_.spheres.empty() && pick(2) == 0;
    if (sphere) {
      const Sphere& s =
          scene_.spheres[static_cast<std::size_t>(pick(static_cast<int>(scene_.spheres.size())))];
      const int what = pick(4);
      Vec3d step(between(-1, 1), between(-1, 1), between(-1, 1));
      if (what == 0) step = normalize(step);
      if (what == 1) step = {double(pick(3) - 1), double(pick(3) - 1), double(pick(3) - 1)};
      return s.centre + s.radius * step;
    }
    const auto index = static_cast<std::size_t>(pick(3));
    const auto& rectangles = scene_.rectangles[index];
    if (rectangles.empty()) return point(1);
    const Rectangle& r =
        rectangles[static_cast<std::size_t>(pick(static_cast<int>(rectangles.size())))];
    const RectangleAxes axes = rectangle_axes(rectangle_kind(index));
    const bool corner = pick(3) == 0;
    Vec3d p;
    p[axes.u] = r.u0 + (r.u1 - r.u0) * (corner ? pick(2) : between(0, 1));
    p[axes.v] = r.v0 + (r.v1 - r.v0) * (corner ? pick(2) : between(0, 1));
    p[axes.k] = r.k;
    return p;
  }

  // Inside, on an edge or at a vertex.
  Vec3d point_of_triangle() {
    const auto count = static_cast<int>(scene_.triangles.size());
    const Triangle& t = scene_.triangles[static_cast<std::size_t>(pick(count))];
    const auto vertex = [&](std::size_t i) {
      return Vec3d(scene_.vertices.positions[t.vertices[i]]);
    };
    const int what = pick(4);
    const double u = what == 0 ? 0 : what == 1 ? pick(2) : between(0, 1);
    const double v = what == 2 ? 1 - u : between(0, 1 - u);
    return (1 - u - v) * vertex(0) + u * vertex(1) + v * vertex(2);
  }

  // Components that are zero of either sign, or next to it.
  void flatten(Vec3f& direction) {
    if (pick(3) != 0) return;
    const float values[] = {0.0f, -0.0f, 1e-18f, -1e-20f, 1e-40f};
    const int keep = pick(3);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis != keep && pick(3) != 0) direction[axis] = values[pick(5)];
    }
    if (pick(4) == 0) direction[keep] = pick(2) == 0 ? 1.0f : -1.0f;
  }

  void bound(Ray& ray) {
    const int what = pick(6);
    if (what == 0) ray.t_min = 1e-3f;
    if (what == 1) ray.t_max = 1.0f;  // to the target itself
    if (what == 2) ray.t_min = static_cast<float>(between(0, 1));
    if (what == 3) ray.t_max = ray.t_min + static_cast<float>(between(0, 2));
    const int rare = pick(2000);
    if (rare == 0) ray.t_max = -1.0f;
    if (rare == 1) ray.t_min = ray.t_max = 1.0f;
    if (rare == 2) ray.direction = {0, 0, 0};
    if (rare == 3) ray.origin.x = std::nanf("");
    if (rare == 4) ray.direction.y = HUGE_VALF;
    if (rare == 5) ray.t_max = std::nanf("");
    if (rare == 6) ray.t_min = -1.0f;
    if (rare == 7) ray.t_min = std::nanf("");
    if (rare == 8) ray.origin.z = 1e30f;
    if (rare == 9) ray.direction = 1e15f * ray.direction;
  }

  const Scene& scene_;
  const NastyConfig& config_;
  std::mt19937_64 random_;
};

}  // namespace

NastyConfig nasty_config(std::uint64_t seed) {
  constexpr double kSizes[] = {1, 1, 10, 1e-6, 1e3, 1e8, 1e17, 1e-15};
  constexpr double kDistances[] = {0, 0, 10, 1e3, 1e6};
  constexpr std::size_t kCounts[] = {1, 2, 3, 8, 17, 40, 100, 300};
  std::mt19937_64 random(seed);
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  NastyConfig config;
  config.shapes = static_cast<Shapes>(pick(kShapesCount));
  config.object_count = kCounts[pick(8)];
  config.size = kSizes[pick(8)];
  config.distance = config.size * kDistances[pick(5)];
  if (config.distance > 1e17) config.distance = 0;
  config.on_grid = pick(2) == 0;
  config.odd_share = pick(2) == 0 ? 0.1 : 0.6;
  // Extents reach a thousand sizes; coordinates must stay where scenes are valid.
  if (config.size > 1e14) config.odd_share = 0;
  return config;
}

Scene nasty_scene(const NastyConfig& config, std::uint64_t seed) {
  return Maker(config, seed).make();
}

std::vector<Ray> nasty_rays(const Scene& scene, const NastyConfig& config, std::size_t count,
                            std::uint64_t seed) {
  RayMaker maker(scene, config, seed);
  std::vector<Ray> rays(count);
  for (Ray& ray : rays) ray = maker.make();
  return rays;
}

}  // namespace dapple::test
