#include "tests/scenes/slivers.h"

#include <array>
#include <cmath>
#include <random>

#include "tests/scenes/meshes.h"

namespace dapple::test {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::size_t pick(std::size_t count) { return engine_() % count; }
  float uniform() { return static_cast<float>(engine_() >> 40) * 0x1p-24f; }
  Vec3f in_cube(float half) {
    const float x = uniform(), y = uniform();
    return {half * (2 * x - 1), half * (2 * y - 1), half * (2 * uniform() - 1)};
  }
  // From `least` to `most`, small ones as often as large ones.
  float size(float least, float most) {
    const float u = uniform();
    float ratio = most / least, result = least;
    for (float share = u; ratio > 1.01f; share = 2 * share - (share >= 0.5f ? 1.0f : 0.0f)) {
      ratio = std::sqrt(ratio);
      if (share >= 0.5f) result *= ratio;
    }
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

struct Maker {
  Scene scene;
  MaterialId material = scene.add_material(Lambertian{});

  std::uint32_t vertex(const Vec3f& at) {
    scene.vertices.positions.push_back(at);
    return static_cast<std::uint32_t>(scene.vertices.positions.size() - 1);
  }
  void triangle(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const std::uint32_t first = vertex(a);
    scene.add_triangle({{first, vertex(b), vertex(c)}}, material);
  }
};

void add_needle(Maker& maker, Random& random) {
  const float length = random.size(1e-4f, 4), width = random.size(1e-5f, 1e-2f);
  const Vec3f at = random.in_cube(2), end = at + random.in_cube(length);
  maker.triangle(at, end, at + random.in_cube(width));
}

void add_beam(Maker& maker, Random& random, const Vec3f& centre) {
  const Vec3f from = centre + random.in_cube(2), way = random.in_cube(2);
  const Vec3f side = random.in_cube(0.01f), up = cross(way, side);
  const std::array<Vec3f, 3> off = {side, up - side, -0.5f * side - up};
  std::array<std::uint32_t, 6> v;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = maker.vertex(from + off[i]);
    v[3 + i] = maker.vertex((from + way) + off[i]);
  }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    maker.scene.add_triangle({{v[a], v[b], v[c]}}, maker.material);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    add(i, j, 3 + j);
    add(i, 3 + j, 3 + i);
  }
  add(0, 1, 2);
  add(3, 4, 5);
}

// In a plane along the axes or across all of them.
void add_coplanar(Maker& maker, Random& random, std::size_t plane) {
  std::array<Vec3f, 3> v;
  const Vec3f at = random.in_cube(2), way = random.in_cube(2);
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = at + (i == 0 ? random.in_cube(0.02f) : i == 1 ? way : Vec3f(0, 0, 0));
    if (plane < 3) v[i][static_cast<int>(plane)] = 0.25f;
    if (plane == 3) v[i].z = 0.5f * v[i].x - 0.25f * v[i].y;
  }
  const std::size_t copies = 1 + random.pick(2);
  for (std::size_t i = 0; i < copies; ++i) maker.triangle(v[i], v[1 - i], v[2]);
}

Scene stretched_mesh(std::size_t triangles, std::uint64_t seed) {
  Scene scene;
  const auto divisions = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 12)) + 1;
  add_cube_mesh({{0, 0, 0}, 1, divisions, 0.5f, 0.2f}, scene.add_material(Lambertian{}), scene);
  const float stretch = 20 + static_cast<float>(seed % 7);
  for (Vec3f& p : scene.vertices.positions) {
    const float along = stretch * (p.x + p.y + p.z);
    p = p + Vec3f(along, 0.7f * along, -0.4f * along);
  }
  return scene;
}

Vec3f vertex_of(const Scene& scene, const Triangle& t, std::size_t i) {
  return scene.vertices.positions[t.vertices[i]];
}

Vec3f target_on(const Scene& scene, const Triangle& t, Random& random) {
  const std::size_t i = random.pick(3);
  const Vec3f a = vertex_of(scene, t, i), b = vertex_of(scene, t, (i + 1) % 3);
  const Vec3f c = vertex_of(scene, t, (i + 2) % 3);
  switch (random.pick(4)) {
    case 0:
      return a;
    case 1:
      return a + random.uniform() * (b - a);
    default:
      const float u = random.uniform();
      return a + u * ((b - a) + random.uniform() * (c - b));
  }
}

}  // namespace

Scene sliver_scene(Slivers kind, std::size_t triangles, std::uint64_t seed) {
  if (kind == Slivers::sheet) return stretched_mesh(triangles, seed);
  Random random(seed);
  Maker maker;
  while (maker.scene.triangles.size() < triangles) {
    if (kind == Slivers::needles) add_needle(maker, random);
    if (kind == Slivers::beams) add_beam(maker, random, {0, 0, 0});
    if (kind == Slivers::distant) add_beam(maker, random, {3000, -2000, 1000});
    if (kind == Slivers::coplanar) add_coplanar(maker, random, random.pick(5));
  }
  return std::move(maker.scene);
}

std::vector<Ray> sliver_rays(const Scene& scene, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Ray> rays(count);
  const auto any = [&]() -> const Triangle& {
    return scene.triangles[random.pick(scene.triangles.size())];
  };
  for (Ray& ray : rays) {
    const Triangle& t = any();
    const Vec3f target = target_on(scene, t, random);
    switch (random.pick(6)) {
      case 0:  // from another triangle
        ray.origin = target_on(scene, any(), random);
        ray.t_min = 1e-4f;
        break;
      case 1:  // almost along it
        ray.origin = target_on(scene, t, random) + random.in_cube(0.01f);
        break;
      case 2:  // from far
        ray.origin = target + random.in_cube(300);
        break;
      case 3: {  // along an axis
        ray.origin = target;
        ray.origin[static_cast<int>(random.pick(3))] -= 5;
        break;
      }
      default:
        ray.origin = target + random.in_cube(3);
    }
    ray.direction = target - ray.origin;
    // A shadow ray sometimes, which ends at the target or shortly before.
    if (random.pick(4) == 0) ray.t_max = random.pick(2) == 0 ? 1.0f : 0.999f;
  }
  return rays;
}

}  // namespace dapple::test
