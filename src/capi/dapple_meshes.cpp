// Meshes, instances and cylinders of the C++ interface.
#include <algorithm>
#include <iterator>
#include <vector>

#include "capi/api_state.h"
#include "scene/validate.h"
#include "scene/validate_instances.h"
#include "scene/vertex_arrays.h"

namespace dapple::v0 {
namespace {

Error bad_data(const std::string& message) {
  return {static_cast<int>(lib::Errc::bad_data), message};
}

bool sizes_agree(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size() / 3;
  const auto fits = [&](std::span<const float> attribute, std::size_t numbers) {
    return attribute.empty() || attribute.size() == vertices * numbers;
  };
  return fits(mesh.positions, 3) && fits(mesh.normals, 3) && fits(mesh.uvs, 2) &&
         fits(mesh.colours, 4) && mesh.triangles.size() % 3 == 0;
}

Vec3f unit_or_zero(const Vec3f& v) {
  const Vec3d wide(v);
  const double length_of = length(wide);
  return length_of > 0 ? Vec3f(wide / length_of) : Vec3f();
}

Vertices vertices_of(const Mesh& mesh) {
  Vertices vertices;
  const auto p = mesh.positions, n = mesh.normals, uv = mesh.uvs, c = mesh.colours;
  for (std::size_t i = 0; i + 2 < p.size(); i += 3) {
    vertices.positions.push_back({p[i], p[i + 1], p[i + 2]});
  }
  for (std::size_t i = 0; i + 2 < n.size(); i += 3) {
    vertices.normals.push_back(unit_or_zero({n[i], n[i + 1], n[i + 2]}));
  }
  for (std::size_t i = 0; i + 1 < uv.size(); i += 2) {
    vertices.uvs[0].push_back({uv[i], uv[i + 1]});
  }
  for (std::size_t i = 0; i + 3 < c.size(); i += 4) {
    vertices.colours.push_back({c[i], c[i + 1], c[i + 2], c[i + 3]});
  }
  return vertices;
}

// A scene of nothing but this mesh, for validate() to look at.
Result<lib::Scene> scene_of(const Mesh& mesh) {
  if (!sizes_agree(mesh)) return bad_data("mesh: the sizes of its spans disagree");
  lib::Scene scene;
  const auto any = scene.add_material(lib::Lambertian{});
  scene.vertices = vertices_of(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    scene.add_triangle({{mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]}}, any);
  }
  if (auto status = validate(scene); !status) {
    return bad_data("mesh: " + lib::to_string(status.error()));
  }
  return scene;
}

// The mesh's triangles, with its vertices added to the scene.
Result<std::vector<Triangle>> move_in(const Mesh& mesh, MaterialId material, lib::Scene& scene) {
  if (static_cast<std::size_t>(material) >= scene.materials.size()) {
    return bad_data("mesh: its material does not exist");
  }
  auto checked = scene_of(mesh);
  if (!checked) return checked.error();
  const std::size_t first = scene.vertices.positions.size();
  const std::size_t most = 0xffffffffu;
  if (checked->vertices.positions.size() > most - first) return bad_data("mesh: too many vertices");
  if (prim_count(scene) + checked->triangles.size() > kMaxObjectCount) {
    return bad_data("mesh: too many triangles");
  }
  append_vertices(checked->vertices, scene.vertices);
  for (Triangle& triangle : checked->triangles) {
    for (std::uint32_t& vertex : triangle.vertices) vertex += static_cast<std::uint32_t>(first);
  }
  return std::move(checked->triangles);
}

// Triangles of the world stand before those of prototypes.
void add_to_world(std::span<const Triangle> triangles, lib::MaterialId material,
                  lib::Scene& scene) {
  const std::size_t first =
      scene.prototypes.empty() ? scene.triangles.size() : scene.prototypes[0].first_triangle;
  const auto split = [&](auto& array) {
    std::remove_reference_t<decltype(array)> tail(
        array.begin() + static_cast<std::ptrdiff_t>(first), array.end());
    array.resize(first);
    return tail;
  };
  const auto tail = split(scene.triangles);
  const auto tail_materials = split(scene.triangle_materials);
  for (const Triangle& triangle : triangles) scene.add_triangle(triangle, material);
  scene.triangles.insert(scene.triangles.end(), tail.begin(), tail.end());
  scene.triangle_materials.insert(scene.triangle_materials.end(), tail_materials.begin(),
                                  tail_materials.end());
  for (Prototype& prototype : scene.prototypes) {
    prototype.first_triangle += static_cast<std::uint32_t>(triangles.size());
  }
}

}  // namespace

Status Scene::add_cylinder(const Point& begin, const Point& end, double radius,
                           MaterialId material) noexcept {
  return guarded([&]() -> Status {
    const Cylinder cylinder{to_vec3(begin), to_vec3(end), radius};
    if (!is_valid(cylinder)) {
      return bad_data("cylinder: a number is not finite or too large, or the radius negative");
    }
    lib::Scene& scene = own_state().scene;
    if (static_cast<std::size_t>(material) >= scene.materials.size()) {
      return bad_data("cylinder: its material does not exist");
    }
    scene.add_cylinder(cylinder, static_cast<lib::MaterialId>(material));
    return {};
  });
}

Status Scene::add_mesh(const Mesh& mesh, MaterialId material) noexcept {
  return guarded([&]() -> Status {
    lib::Scene& scene = own_state().scene;
    const auto triangles = move_in(mesh, material, scene);
    if (!triangles) return triangles.error();
    add_to_world(*triangles, static_cast<lib::MaterialId>(material), scene);
    return {};
  });
}

Result<PrototypeId> Scene::add_prototype(const Mesh& mesh, MaterialId material) noexcept {
  return guarded([&]() -> Result<PrototypeId> {
    if (mesh.triangles.empty()) return bad_data("prototype: it has no triangles");
    lib::Scene& scene = own_state().scene;
    const auto triangles = move_in(mesh, material, scene);
    if (!triangles) return triangles.error();
    const std::vector<lib::MaterialId> ids(triangles->size(),
                                           static_cast<lib::MaterialId>(material));
    return static_cast<PrototypeId>(scene.add_prototype(*triangles, ids));
  });
}

Status Scene::add_instance(PrototypeId prototype, const Transform& to_world) noexcept {
  return guarded([&]() -> Status {
    lib::Scene& scene = own_state().scene;
    if (static_cast<std::size_t>(prototype) >= scene.prototypes.size()) {
      return bad_data("instance: its prototype does not exist");
    }
    lib::Instance instance;
    std::copy(&to_world.rows[0][0], &to_world.rows[0][0] + 12, &instance.to_world.rows[0][0]);
    instance.prototype = static_cast<std::uint32_t>(prototype);
    if (!is_valid(instance.to_world)) {
      return bad_data("instance: its transform is not finite, too large or cannot be inverted");
    }
    scene.add_instance(instance);
    return {};
  });
}

}  // namespace dapple::v0
