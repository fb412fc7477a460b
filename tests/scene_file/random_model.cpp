#include "tests/scene_file/random_model.h"

#include <algorithm>
#include <cstring>

#include "scene/layered_fields.h"
#include "tests/scene_file/random_numbers.h"
#include "tests/scene_file/random_scene.h"

namespace dapple::test {
namespace {

class ModelMaker {
 public:
  explicit ModelMaker(std::uint64_t seed)
      : numbers_(seed + 1'000'000), scene_(random_scene(seed, numbers_.below(20))) {}

  Scene make() {
    add_images();
    add_textures();
    add_materials();
    add_vertices();
    if (!scene_.vertices.positions.empty()) add_triangles();
    for (std::uint32_t n = numbers_.below(5); n > 0; --n) add_cylinder();
    add_lights();
    add_environment();
    add_cameras();
    return std::move(scene_);
  }

 private:
  // A number of `low` to `high`, both of which it often is.
  float between(float low, float high) {
    const std::uint32_t which = numbers_.below(4);
    if (which < 2) return which == 0 ? low : high;
    const float bounded_low = std::max(low, -1000.0f), bounded_high = std::min(high, 1000.0f);
    return std::clamp(bounded_low + numbers_.unitf() * (bounded_high - bounded_low), low, high);
  }
  template <class Enum>
  Enum any(std::uint32_t count) {
    return static_cast<Enum>(numbers_.below(count));
  }
  MaterialId material() {
    return any<MaterialId>(static_cast<std::uint32_t>(scene_.materials.size()));
  }

  void add_images() {
    for (std::uint32_t n = numbers_.below(4); n > 0; --n) {
      TextureImage image;
      image.width = 1 + numbers_.below(9);
      image.height = 1 + numbers_.below(9);
      image.format = any<TexelFormat>(3);
      image.offset = (scene_.texels.size() + 15) / 16 * 16;
      scene_.images.push_back(image);
      scene_.texels.resize(image.offset + image.bytes());
      std::generate(scene_.texels.begin() + static_cast<std::ptrdiff_t>(image.offset),
                    scene_.texels.end(),
                    [&] { return static_cast<std::uint8_t>(numbers_.below(256)); });
    }
  }

  void add_textures() {
    if (scene_.images.empty()) return;
    for (std::uint32_t n = numbers_.below(5); n > 0; --n) {
      Texture texture;
      texture.image = any<ImageId>(static_cast<std::uint32_t>(scene_.images.size()));
      texture.wrap_u = any<Wrap>(3);
      texture.wrap_v = any<Wrap>(3);
      texture.filter = any<Filter>(2);
      scene_.textures.push_back(texture);
    }
  }

  LayeredMaterial layered() {
    LayeredMaterial m;
    m.model = any<BaseModel>(2);
    m.alpha_mode = any<AlphaMode>(3);
    m.unlit = numbers_.below(2);
    m.double_sided = numbers_.below(2);
    for (const LayeredNumber& n : layered_numbers()) m.*n.member = between(n.low, n.high);
    for (const LayeredColour& c : layered_colours()) {
      m.*c.member = {between(0, c.high), between(0, c.high), between(0, c.high)};
    }
    for (TextureSlot& slot : m.maps) {
      if (scene_.textures.empty() || numbers_.below(3) > 0) continue;
      slot.texture = any<TextureId>(static_cast<std::uint32_t>(scene_.textures.size()));
      slot.uv_set = numbers_.below(2);
      for (auto& row : slot.to_uv) {
        for (float& x : row) x = between(-1e9f, 1e9f);
      }
    }
    return m;
  }

  void add_materials() {
    for (std::uint32_t n = numbers_.below(4); n > 0; --n) {
      scene_.add_material(Layered{static_cast<std::uint32_t>(scene_.layered_materials.size())});
      scene_.layered_materials.push_back(layered());
    }
  }

  void add_vertices() {
    Vertices& vertices = scene_.vertices;
    vertices.positions.resize(numbers_.below(3) * 17);
    for (Vec3f& p : vertices.positions) {
      p = {100 * numbers_.unitf(), -numbers_.unitf(), 0.5f + numbers_.unitf()};
    }
    const auto fill = [&](auto& array, auto make) {
      if (numbers_.below(2) == 0) return;
      array.resize(vertices.positions.size());
      for (auto& element : array) element = make();
    };
    fill(vertices.normals, [&] { return numbers_.normal(); });
    fill(vertices.tangents, [&] { return numbers_.tangent(); });
    for (auto& set : vertices.uvs) fill(set, [&] { return numbers_.uv(); });
    fill(vertices.colours, [&] {
      const Vec3f c = numbers_.colourf();
      return Vec4f{c.x, c.y, c.z, numbers_.unitf()};
    });
  }

  Triangle triangle() {
    const auto count = static_cast<std::uint32_t>(scene_.vertices.positions.size());
    return {{numbers_.below(count), numbers_.below(count), numbers_.below(count)}};
  }

  void add_triangles() {
    for (std::uint32_t n = numbers_.below(40); n > 0; --n) {
      scene_.add_triangle(triangle(), material());
    }
    const std::uint32_t prototype_count = numbers_.below(4);
    for (std::uint32_t i = 0; i < prototype_count; ++i) {
      const std::vector<Triangle> triangles(1 + numbers_.below(9), triangle());
      const std::vector<MaterialId> materials(triangles.size(), material());
      scene_.add_prototype(triangles, materials);
    }
    if (prototype_count == 0) return;
    for (std::uint32_t n = numbers_.below(6); n > 0; --n) {
      Instance instance;
      for (int i = 0; i < 3; ++i) {
        for (float& x : instance.to_world.rows[i]) x = numbers_.unitf() - 0.5f;
        instance.to_world.rows[i][i] += 2;
      }
      instance.prototype = numbers_.below(prototype_count);
      scene_.add_instance(instance);
    }
  }

  void add_cylinder() {
    scene_.add_cylinder({numbers_.point(), numbers_.point(), std::fabs(numbers_.coordinate())},
                        material());
  }

  void add_lights() {
    for (std::uint32_t n = numbers_.below(4); n > 0; --n) {
      Light light;
      light.kind = any<LightKind>(3);
      light.position = Vec3f(numbers_.colour());
      light.direction = numbers_.direction();
      light.intensity = numbers_.colourf();
      light.outer_angle = between(0, 3.14159f);
      light.inner_angle = between(0, light.outer_angle);
      scene_.lights.push_back(light);
    }
  }

  void add_environment() {
    scene_.environment.kind = any<EnvironmentKind>(5);
    scene_.environment.colour = numbers_.colourf();
    scene_.environment.rotation = between(-360, 360);
    if (!scene_.images.empty()) {
      scene_.environment.image = any<ImageId>(static_cast<std::uint32_t>(scene_.images.size()));
    } else if (scene_.environment.kind == EnvironmentKind::image) {
      scene_.environment.kind = EnvironmentKind::none;
    }
    if (numbers_.below(3) == 0) scene_.environment = {};
  }

  void add_cameras() {
    scene_.camera.orthographic_height = numbers_.below(2) == 0 ? 0 : 0.5 + numbers_.unit();
    for (const char* name : {"", "Front", "Über der Küste", "二"}) {
      if (numbers_.below(2) == 0) continue;
      NamedCamera camera{{}, scene_.camera};
      std::memcpy(camera.name.data(), name, std::strlen(name));
      camera.camera.look_from = numbers_.point();
      scene_.cameras.push_back(camera);
    }
  }

  Numbers numbers_;
  Scene scene_;
};

}  // namespace

Scene random_model(std::uint64_t seed) { return ModelMaker(seed).make(); }

Scene large_mesh(std::uint32_t side) {
  Scene scene;
  const MaterialId grey = scene.add_material(Lambertian{{0.5, 0.5, 0.5}});
  const auto vertex = [&](std::uint32_t x, std::uint32_t z) { return z * (side + 1) + x; };
  for (std::uint32_t z = 0; z <= side; ++z) {
    for (std::uint32_t x = 0; x <= side; ++x) {
      const auto u = static_cast<float>(x), v = static_cast<float>(z);
      scene.vertices.positions.push_back({u, static_cast<float>(x * z % 7), v});
      scene.vertices.normals.push_back({0, 1, 0});
      scene.vertices.uvs[0].push_back({u, v});
    }
  }
  for (std::uint32_t z = 0; z < side; ++z) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = vertex(x, z), b = vertex(x + 1, z);
      const std::uint32_t c = vertex(x, z + 1), d = vertex(x + 1, z + 1);
      scene.add_triangle({{a, c, b}}, grey);
      scene.add_triangle({{b, c, d}}, grey);
    }
  }
  return scene;
}

}  // namespace dapple::test
