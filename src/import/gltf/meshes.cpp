#include "import/gltf/meshes.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "import/gltf/deform.h"
#include "import/tangents.h"
#include "import/vertex_arrays.h"
#include "scene/validate.h"

namespace dapple::gltf {
namespace {

void flip(std::vector<Triangle>& triangles) {
  for (Triangle& triangle : triangles) std::swap(triangle.vertices[1], triangle.vertices[2]);
}

bool mirrors(const std::vector<Transformd>& joints) {
  std::size_t mirroring = 0;
  for (const Transformd& joint : joints) mirroring += determinant(joint) < 0 ? 1 : 0;
  return 2 * mirroring > joints.size();
}

// One mesh of several primitives.
void append(const Vertices& vertices, const std::vector<Triangle>& triangles, MaterialId material,
            MeshData& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.positions.size());
  append_vertices(vertices, mesh.vertices);
  for (const Triangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.vertices;
    mesh.triangles.push_back({{a + first, b + first, c + first}});
    mesh.materials.push_back(material);
  }
}

// Nothing for a transform that instances cannot have: flat, or beyond single precision.
std::optional<Transformf> rounded_transform(const Transformd& m) {
  Transformf rounded;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      rounded.rows[i][j] = static_cast<float>(m.rows[i][j]);
    }
  }
  return is_valid(rounded) ? std::optional(rounded) : std::nullopt;
}

// False where every triangle becomes a line or a point, or one that is not finite.
bool keeps_surfaces(const Transformd& m) {
  const Vec3d x = m.vector(Vec3d(1, 0, 0)), y = m.vector(Vec3d(0, 1, 0));
  const Vec3d z = m.vector(Vec3d(0, 0, 1));
  double area = 0;
  for (const Vec3d& side : {cross(x, y), cross(y, z), cross(z, x)}) area += max_abs_component(side);
  return area > 0 && std::isfinite(area);
}

// Points and lines have no surface of their own that a texture could lie on: colours of vertices
// become materials, in steps fine enough that none is seen.
class ColouredMaterials {
 public:
  ColouredMaterials(SceneBuilder& builder, const LayeredMaterial& material)
      : builder_(builder), material_(material) {}

  MaterialId of(const Vec4f& colour) {
    const std::uint32_t key =
        step(colour.x) << 18 | step(colour.y) << 12 | step(colour.z) << 6 | step(colour.w);
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    LayeredMaterial coloured = material_;
    coloured.base_colour = material_.base_colour *
                           Vec3f(level(key >> 18), level(key >> 12 & 63), level(key >> 6 & 63));
    coloured.alpha *= level(key & 63);
    return known_[key] = builder_.add_material(coloured);
  }

 private:
  // 64 levels by the square root, which is near to how the eye tells them apart.
  static std::uint32_t step(float value) {
    const float root = std::sqrt(value > 0 ? (value < 1 ? value : 1) : 0);
    return static_cast<std::uint32_t>(root * 63 + 0.5f);
  }
  static float level(std::uint32_t step) {
    const float root = static_cast<float>(step) / 63;
    return root * root;
  }

  SceneBuilder& builder_;
  const LayeredMaterial& material_;
  std::map<std::uint32_t, MaterialId> known_;
};

Status add_points_and_lines(const Primitive& primitive, const Vertices& v,
                            const LayeredMaterial& material, SceneBuilder& builder) {
  const std::uint64_t count = primitive.points.size() + primitive.lines.size();
  constexpr std::uint64_t kBytes = 2 * sizeof(Cylinder) + sizeof(MaterialId);
  if (auto taken = builder.budget().take(count, kBytes, "points and lines"); !taken) return taken;
  ColouredMaterials materials(builder, material);
  const auto colour = [&](std::uint32_t i) {
    return v.colours.empty() ? Vec4f{1, 1, 1, 1} : v.colours[i];
  };
  for (const std::uint32_t i : primitive.points) {
    builder.add_point(Vec3d(v.positions[i]), materials.of(colour(i)));
  }
  for (const auto& [a, b] : primitive.lines) {
    builder.add_line(Vec3d(v.positions[a]), Vec3d(v.positions[b]),
                     materials.of(0.5f * (colour(a) + colour(b))));
  }
  return {};
}

// Where the file has none and the material needs them.
void add_tangents(const LayeredMaterial& material, Vertices& vertices,
                  std::vector<Triangle>& triangles) {
  const bool usable = !vertices.tangents.empty() && !vertices.normals.empty();
  if (usable || !needs_tangents(material)) return;
  make_tangents(tangent_uv_set(material), vertices, triangles);
}

}  // namespace

Expected<Meshes::LoadedMesh> Meshes::load(std::uint32_t index) {
  LoadedMesh mesh{index, {}};
  const JsonValue& primitives = context_.document["meshes"][index]["primitives"];
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const std::string pointer = fmt::format("/meshes/{}/primitives/{}", index, i);
    const auto material = materials_.of_primitive(primitives[i], pointer);
    if (!material) return tl::unexpected(material.error());
    auto primitive = read_primitive(accessors_, context_, primitives[i], pointer);
    if (!primitive) {
      if (auto ok = context_.tolerate(primitive.error()); !ok) return tl::unexpected(ok.error());
      continue;
    }
    if (primitive->vertices.positions.empty()) {
      context_.warn(pointer, "it has no positions and is left out");
      continue;
    }
    mesh.primitives.push_back({std::move(*primitive), *material});
  }
  return mesh;
}

Status Meshes::add_baked(const LoadedMesh& mesh, const Placement& placement,
                         const Transformd& to_world) {
  for (const auto& [primitive, material] : mesh.primitives) {
    Vertices vertices = morphed(primitive, placement.weights);
    std::vector<Triangle> triangles = primitive.triangles;
    const bool skinned = !placement.joints.empty() && primitive.influences.per_vertex > 0;
    if (!skinned) {
      place(to_world, vertices);
    } else if (!skin(primitive.influences, placement.joints, vertices)) {
      const auto error = context_.document.error(fmt::format("/nodes/{}", placement.node),
                                                 "a vertex names a joint that its skin lacks");
      if (auto ok = context_.tolerate(error.value()); !ok) return ok;
      continue;
    }
    if (skinned ? mirrors(placement.joints) : determinant(to_world) < 0) flip(triangles);
    add_tangents(material, vertices, triangles);
    if (auto ok = add_points_and_lines(primitive, vertices, material, context_.builder); !ok) {
      return ok;
    }
    if (triangles.empty()) continue;
    const MaterialId id = context_.builder.add_material(material);
    const MeshData data{std::move(vertices), std::move(triangles),
                        std::vector<MaterialId>(primitive.triangles.size(), id)};
    if (auto added = context_.builder.add_mesh(data); !added) {
      return context_.document.error(fmt::format("/meshes/{}", mesh.index), added.error().message);
    }
  }
  return {};
}

Status Meshes::add_shared(const LoadedMesh& mesh, const std::vector<const Placement*>& placements) {
  MeshData data;
  for (const auto& [primitive, material] : mesh.primitives) {
    if (primitive.triangles.empty()) continue;
    Vertices vertices = morphed(primitive, placements[0]->weights);
    std::vector<Triangle> triangles = primitive.triangles;
    add_tangents(material, vertices, triangles);
    append(vertices, triangles, context_.builder.add_material(material), data);
  }
  const std::string pointer = fmt::format("/meshes/{}", mesh.index);
  const auto prototype = context_.builder.add_prototype(data);
  if (!prototype) return context_.document.error(pointer, prototype.error().message);
  std::size_t without_surface = 0;
  for (const Placement* placement : placements) {
    for (const Transformd& to_world : placement->to_world) {
      const auto rounded = rounded_transform(to_world);
      if (!rounded && keeps_surfaces(to_world)) {
        // Flat: as a mesh that one node shows.
        if (auto added = add_baked(mesh, *placement, to_world); !added) return added;
        continue;
      }
      for (const auto& [primitive, material] : mesh.primitives) {
        if (!primitive.triangles.empty()) continue;
        Vertices vertices = morphed(primitive, placement->weights);
        place(to_world, vertices);
        if (auto ok = add_points_and_lines(primitive, vertices, material, context_.builder); !ok) {
          return ok;
        }
      }
      if (*prototype == kNoPrototype) continue;
      if (!rounded) {
        ++without_surface;
      } else if (auto added = context_.builder.add_instance(*prototype, *rounded); !added) {
        return context_.document.error(pointer, added.error().message);
      }
    }
  }
  if (without_surface > 0) {
    context_.warn(pointer, fmt::format("{} of its instances are left out: their transforms leave "
                                       "no surface of them",
                                       without_surface));
  }
  return {};
}

Status Meshes::add(const std::vector<PlacedNode>& nodes, const std::vector<NodePose>& poses,
                   const std::vector<Transformd>& everywhere) {
  // In the order of meshes, so that each is read once.
  std::map<std::uint32_t, std::vector<Placement>> by_mesh;
  for (const PlacedNode& node : nodes) {
    if (!context_.document["nodes"][node.index].has("mesh")) continue;
    auto placed = placement(node, poses[node.index], everywhere);
    if (!placed) {
      if (auto ok = context_.tolerate(placed.error()); !ok) return ok;
      continue;
    }
    by_mesh[placed->mesh].push_back(std::move(*placed));
  }
  for (const auto& [index, placements] : by_mesh) {
    const auto mesh = load(index);
    if (!mesh) return tl::unexpected(mesh.error());
    std::map<std::vector<double>, std::vector<const Placement*>> shared;
    for (const Placement& placement : placements) {
      if (placement.joints.empty()) {
        shared[placement.weights].push_back(&placement);
      } else if (auto added = add_baked(*mesh, placement, placement.to_world[0]); !added) {
        return added;
      }
    }
    for (const auto& [weights, same] : shared) {
      const bool alone = same.size() == 1 && same[0]->to_world.size() == 1;
      const Status added =
          alone ? add_baked(*mesh, *same[0], same[0]->to_world[0]) : add_shared(*mesh, same);
      if (!added) return added;
    }
  }
  return {};
}

}  // namespace dapple::gltf
