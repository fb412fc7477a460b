#include "tests/scenes/meshes.h"

#include <cmath>
#include <map>

#include "math/random.h"

namespace dapple::test {
namespace {

class MeshMaker {
 public:
  MeshMaker(const CubeMesh& mesh, MaterialId material, Scene& scene)
      : mesh_(mesh), material_(material), scene_(scene) {}

  void add_side(int axis, int level) {
    for (int i = 0; i < mesh_.divisions; ++i) {
      for (int j = 0; j < mesh_.divisions; ++j) {
        const auto corner = [&](int di, int dj) {
          std::array<int, 3> at{};
          at[static_cast<std::size_t>(axis)] = level;
          at[static_cast<std::size_t>((axis + 1) % 3)] = i + di;
          at[static_cast<std::size_t>((axis + 2) % 3)] = j + dj;
          return vertex(at);
        };
        add(corner(0, 0), corner(1, 0), corner(1, 1), level == 0);
        add(corner(0, 0), corner(1, 1), corner(0, 1), level == 0);
      }
    }
  }

 private:
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
    scene_.add_triangle(turned ? Triangle{{a, c, b}} : Triangle{{a, b, c}}, material_);
  }

  std::uint32_t vertex(const std::array<int, 3>& at) {
    const auto [found, is_new] =
        indices_.try_emplace(at, static_cast<std::uint32_t>(scene_.vertices.positions.size()));
    if (is_new) scene_.vertices.positions.push_back(position(at));
    return found->second;
  }

  Vec3f position(const std::array<int, 3>& at) const {
    Vec3f p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = 2.0f * static_cast<float>(at[static_cast<std::size_t>(axis)]) /
                    static_cast<float>(mesh_.divisions) -
                1.0f;
    }
    const float radius = length(p);
    const float round = 1.0f + mesh_.roundness * (1.0f / radius - 1.0f);
    const auto u = uniform4(static_cast<std::uint32_t>(at[0]), static_cast<std::uint32_t>(at[1]),
                            static_cast<std::uint32_t>(at[2]), 3, 11);
    return mesh_.centre + (mesh_.size * round * (1.0f + mesh_.bumps * (u[0] - 0.5f))) * p;
  }

  const CubeMesh& mesh_;
  MaterialId material_;
  Scene& scene_;
  std::map<std::array<int, 3>, std::uint32_t> indices_;
};

}  // namespace

void add_cube_mesh(const CubeMesh& mesh, MaterialId material, Scene& scene) {
  MeshMaker maker(mesh, material, scene);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int level : {0, mesh.divisions}) maker.add_side(axis, level);
  }
}

}  // namespace dapple::test
