#include "kernels/mesh_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/functions.h"
#include "math/random.h"
#include "util/parse_number.h"

namespace dapple::bench {
namespace {

constexpr std::uint64_t kSeed = 0x6d657368u;
constexpr std::int64_t kMaxTriangles = 50'000'000;

std::array<float, 4> random4(std::uint32_t a, std::uint32_t b) {
  return uniform4(a, b, 0, 0, kSeed);
}

class Maker {
 public:
  Scene scene;

  Maker() { material_ = scene.add_material(Lambertian{{0.7, 0.7, 0.7}}); }

  std::uint32_t vertex(const Vec3f& at) {
    scene.vertices.positions.push_back(at);
    return static_cast<std::uint32_t>(scene.vertices.positions.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    scene.add_triangle({{a, b, c}}, material_);
  }
  void quad(const std::array<std::uint32_t, 4>& v) {
    triangle(v[0], v[1], v[2]);
    triangle(v[0], v[2], v[3]);
  }
  void look(const Vec3d& from, const Vec3d& at, double angle) {
    scene.camera.look_from = from;
    scene.camera.look_at = at;
    scene.camera.vertical_fov = angle;
    scene.camera.aperture = 0;
    scene.camera.focus_distance = 1;
  }

 private:
  MaterialId material_{};
};

// A grid of rings and segments; place(u, v) for u, v in [0, 1].
template <class Place>
void add_grid(Maker& maker, std::uint32_t rings, std::uint32_t segments, const Place& place) {
  const auto first = static_cast<std::uint32_t>(maker.scene.vertices.positions.size());
  for (std::uint32_t r = 0; r <= rings; ++r) {
    for (std::uint32_t s = 0; s <= segments; ++s) {
      maker.vertex(place(static_cast<float>(r) / static_cast<float>(rings),
                         static_cast<float>(s) / static_cast<float>(segments)));
    }
  }
  for (std::uint32_t r = 0; r < rings; ++r) {
    for (std::uint32_t s = 0; s < segments; ++s) {
      const std::uint32_t a = first + r * (segments + 1) + s, b = a + segments + 1;
      maker.quad({a, b, b + 1, a + 1});
    }
  }
}

Vec3f on_sphere(float u, float v, float radius) {
  const auto theta = sin_cos_turns(0.5f * u), phi = sin_cos_turns(v);
  return {radius * theta.sin * phi.cos, radius * theta.cos, radius * theta.sin * phi.sin};
}

void add_bumpy_sphere(Maker& maker, std::uint64_t count, const Vec3f& centre, float size) {
  const auto rings = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count) / 4));
  add_grid(maker, std::max(rings, 2u), std::max(2 * rings, 3u), [&](float u, float v) {
    float height = 0;
    for (const float k : {3.0f, 7.0f, 17.0f, 41.0f}) {
      height += sin_cos_turns(0.5f * k * u).sin * sin_cos_turns(k * v + 0.1f * k).sin / k;
    }
    return centre + on_sphere(u, v, size * (1 + 0.3f * height));
  });
}

Scene bumps(std::uint64_t count) {
  Maker maker;
  add_bumpy_sphere(maker, count, {0, 0, 0}, 1);
  maker.look({0.6, 0.8, 2.6}, {0, 0, 0}, 50);
  return std::move(maker.scene);
}

// A beam from a to b, turned as the ground plan says: eight long triangles.
void add_beam(Maker& maker, const Vec3f& a, const Vec3f& b, float width) {
  const Vec3f along = normalize(b - a);
  const Vec3f helper = std::fabs(along.y) < 0.9f ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0);
  const Vec3f side = width * normalize(cross(along, helper));
  const Vec3f up = width * normalize(cross(side, along));
  std::array<std::uint32_t, 8> v;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3f off = (i == 0 || i == 3 ? 1.0f : -1.0f) * side + (i < 2 ? 1.0f : -1.0f) * up;
    v[i] = maker.vertex(a + off);
    v[4 + i] = maker.vertex(b + off);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    maker.quad({v[i], v[j], v[4 + j], v[4 + i]});
  }
}

// Towers of beams that run up, along and across.
Scene city(std::uint64_t count) {
  constexpr std::uint32_t kBeams = 40;
  const auto side = std::max(
      1u, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count) / (8.0 * kBeams))));
  Maker maker;
  for (std::uint32_t x = 0; x < side; ++x) {
    for (std::uint32_t z = 0; z < side; ++z) {
      const auto u = random4(x, 7919 * z + 1);
      const Vec3f foot(2.0f * static_cast<float>(x), 0, 2.0f * static_cast<float>(z));
      const float height = 1 + 9 * u[0] * u[1], lift_of_roof = 0.5f;
      const auto turn = sin_cos_turns(u[2]);
      const Vec3f east(0.8f * turn.cos, 0, 0.8f * turn.sin);
      const Vec3f north(-east.z, 0, east.x);
      for (std::uint32_t i = 0; i < kBeams; ++i) {
        const auto r = random4(x * side + z, 1000 + i);
        const Vec3f from = foot + (2 * r[0] - 1) * east + (2 * r[1] - 1) * north;
        const Vec3f lift(0, height * r[2], 0);
        const Vec3f to = i % 3 == 0   ? from + Vec3f(0, height, 0)
                         : i % 3 == 1 ? from + lift + 2 * (r[3] - 0.5f) * east + lift_of_roof * lift
                                      : foot + north + (2 * r[3] - 1) * east + lift;
        add_beam(maker, i % 3 == 0 ? from : from + lift, to, 0.01f);
      }
    }
  }
  const double across = 2.0 * side;
  maker.look({-0.1 * across, 0.15 * across + 5, -0.1 * across}, {0.5 * across, 0, 0.5 * across},
             50);
  return std::move(maker.scene);
}

// Girders of a fifth of the whole in all directions: hardly anything of their boxes is filled.
Scene girders(std::uint64_t count) {
  Maker maker;
  for (std::uint32_t i = 0; i < count / 8; ++i) {
    const auto at = random4(i, 6), way = random4(i, 7);
    const Vec3f from(2 * at[0] - 1, 2 * at[1] - 1, 2 * at[2] - 1);
    const Vec3f along(way[0] - 0.5f, way[1] - 0.5f, way[2] - 0.5f);
    add_beam(maker, from, from + 0.4f * normalize(along), 0.0005f + 0.001f * way[3]);
  }
  maker.look({0.5, 0.7, 3.2}, {0, 0, 0}, 45);
  return std::move(maker.scene);
}

Scene soup(std::uint64_t count) {
  Maker maker;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto at = random4(i, 2), shape = random4(i, 3), more = random4(i, 4);
    // From tiny to a tenth of the whole, the small ones many.
    const float size = 0.1f * shape[3] * shape[3] * shape[3] + 0.002f;
    const Vec3f centre(2 * at[0] - 1, 2 * at[1] - 1, 2 * at[2] - 1);
    const std::uint32_t a = maker.vertex(centre);
    const std::uint32_t b =
        maker.vertex(centre + size * Vec3f(shape[0] - 0.5f, shape[1] - 0.5f, shape[2] - 0.5f));
    const std::uint32_t c =
        maker.vertex(centre + size * Vec3f(more[0] - 0.5f, more[1] - 0.5f, more[2] - 0.5f));
    maker.triangle(a, b, c);
  }
  maker.look({0.5, 0.7, 3.2}, {0, 0, 0}, 45);
  return std::move(maker.scene);
}

void add_box(Maker& maker, const Vec3f& lo, const Vec3f& hi) {
  std::array<std::uint32_t, 8> v;
  for (std::size_t i = 0; i < 8; ++i) {
    v[i] = maker.vertex({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
  }
  for (const auto& side :
       {std::array{0, 1, 3, 2}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 3, 7, 6}, std::array{0, 2, 6, 4}, std::array{1, 3, 7, 5}}) {
    maker.quad({v[static_cast<std::size_t>(side[0])], v[static_cast<std::size_t>(side[1])],
                v[static_cast<std::size_t>(side[2])], v[static_cast<std::size_t>(side[3])]});
  }
}

Scene interior(std::uint64_t count) {
  constexpr int kColumns = 12, kThings = 20;
  Maker maker;
  add_box(maker, {-10, 0, -6}, {10, 6, 6});
  for (int i = 0; i < kColumns; ++i) {
    const float x = -9 + 3.6f * static_cast<float>(i / 2), z = i % 2 == 0 ? -3.0f : 3.0f;
    add_grid(maker, 1, 48, [&](float u, float v) {
      const auto turn = sin_cos_turns(v);
      return Vec3f(x + 0.3f * turn.cos, 6 * u, z + 0.3f * turn.sin);
    });
    add_box(maker, {x - 0.5f, 0, z - 0.5f}, {x + 0.5f, 0.3f, z + 0.5f});
  }
  for (std::uint32_t i = 0; i < kThings; ++i) {
    const auto u = random4(i, 5);
    const Vec3f at(18 * u[0] - 9, 0.4f + 0.3f * u[2], 4 * u[1] - 2);
    add_bumpy_sphere(maker, count / kThings, at, 0.2f + 0.3f * u[3]);
  }
  maker.look({-8.5, 2.2, 0.4}, {0, 1.2, 0}, 65);
  return std::move(maker.scene);
}

struct Generator {
  std::string_view name;
  Scene (*make)(std::uint64_t);
};
constexpr Generator kGenerators[] = {{"bumps:", bumps},
                                     {"city:", city},
                                     {"girders:", girders},
                                     {"soup:", soup},
                                     {"interior:", interior}};

}  // namespace

Expected<std::optional<Scene>> make_mesh_scene(const std::string& name) {
  for (const Generator& generator : kGenerators) {
    if (!name.starts_with(generator.name)) continue;
    const auto count = parse_integer(std::string_view(name).substr(generator.name.size()),
                                     "a number of triangles", 100, kMaxTriangles);
    if (!count) return tl::unexpected(count.error());
    return std::optional<Scene>(generator.make(static_cast<std::uint64_t>(*count)));
  }
  return std::optional<Scene>();
}

}  // namespace dapple::bench
