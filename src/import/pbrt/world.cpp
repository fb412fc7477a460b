#include "import/pbrt/world.h"

#include <fmt/format.h>

#include <cmath>

#include "import/default_material.h"
#include "import/vertex_arrays.h"

namespace dapple::pbrt {
namespace {

Error at_place(const Error& error, const std::string& place) {
  return {error.code, error.message, error.place.empty() ? place : error.place};
}

// The factor of a transformation that only turns, moves, mirrors and scales evenly.
std::optional<double> even_scale(const Transformd& m) {
  const Vec3d x = m.vector(Vec3d(1, 0, 0)), y = m.vector(Vec3d(0, 1, 0)),
              z = m.vector(Vec3d(0, 0, 1));
  const double scale = length(x), slack = 1e-6 * scale;
  const bool even = std::fabs(length(y) - scale) <= slack &&
                    std::fabs(length(z) - scale) <= slack &&
                    std::fabs(dot(x, y)) <= slack * scale &&
                    std::fabs(dot(y, z)) <= slack * scale && std::fabs(dot(z, x)) <= slack * scale;
  if (!even || !(scale > 0)) return std::nullopt;
  return scale;
}

// Where a medium ends; without one there is nothing to see.
bool is_invisible(const GraphicsState& state) {
  const bool is_interface = state.material && state.material->transmission == 1 &&
                            state.material->ior == 1 && state.material->specular == 0;
  return is_interface && !state.emission && state.inside == state.outside;
}

void append(const MeshData& from, MeshData& to) {
  const auto first = static_cast<std::uint32_t>(to.vertices.positions.size());
  append_vertices(from.vertices, to.vertices);
  for (const Triangle& triangle : from.triangles) {
    const auto& [a, b, c] = triangle.vertices;
    to.triangles.push_back({{first + a, first + b, first + c}});
  }
  to.materials.insert(to.materials.end(), from.materials.begin(), from.materials.end());
}

}  // namespace

MaterialId World::material_of(const GraphicsState& state, const Params& params) {
  LayeredMaterial material;
  if (state.material) {
    material = *state.material;
  } else {
    material.base_colour = {0.5f, 0.5f, 0.5f};
    material.specular = 0;
  }
  if (state.emission) {
    material.emission = *state.emission;
    // pbrt's area lights shine to the outside only.
    if (!state.two_sided) material.double_sided = 0;
  }
  const bool is_open = material.transmission > 0 && material.thickness > 0;
  if (!state.inside.empty() && state.inside != state.outside) {
    const auto found = media_.find(state.inside);
    if (found == media_.end()) {
      context_.warn(params.place(), fmt::format("there is no medium '{:.60}'", state.inside));
    } else if (is_open) {
      fill_with(found->second, material);
    }
  }
  filling_.insert(state.inside);
  if (!state.outside.empty()) surrounding_.try_emplace(state.outside, params.place());
  return context_.import.builder().add_material(material);
}

Status World::add_shape(const GraphicsState& state, const std::string& kind, const Params& params) {
  for (const char* ignored : {"alpha", "shadowalpha"}) {
    if (params.find(ignored, {""}) != nullptr) {
      context_.warn(params.place(), "the transparency of a shape is not used");
    }
  }
  auto shape = shapes_.make(context_, kind, params);
  if (!shape) return tl::unexpected(shape.error());
  if (!*shape || is_invisible(state)) return {};
  const MaterialId material = material_of(state, params);
  const Transformd to_scene = object_ ? state.to_world : context_.to_scene * state.to_world;
  const auto added =
      (*shape)->radius && !object_ && even_scale(to_scene)
          ? add_sphere(state, *(*shape)->radius, material)
          : add_mesh(to_scene, state.reversed, material,
                     (*shape)->radius ? sphere_mesh(*(*shape)->radius) : std::move((*shape)->mesh));
  if (!added) return tl::unexpected(at_place(added.error(), params.place()));
  return {};
}

Status World::add_sphere(const GraphicsState& state, double radius, MaterialId material) {
  const Transformd to_scene = context_.to_scene * state.to_world;
  if (auto taken = context_.import.builder().budget().take(1, sizeof(Sphere), "spheres"); !taken) {
    return taken;
  }
  const double size = radius * *even_scale(to_scene);
  context_.import.builder().add_sphere(to_scene.point(Vec3d()), state.reversed ? -size : size,
                                       material);
  return {};
}

Status World::add_mesh(const Transformd& to_scene, bool reversed, MaterialId material,
                       MeshData mesh) {
  if (auto placed = place(to_scene, reversed, mesh); !placed) return placed;
  mesh.materials.assign(mesh.triangles.size(), material);
  if (!object_) return context_.import.builder().add_mesh(mesh);
  auto taken = context_.import.builder().budget().take(mesh.vertices.positions.size(),
                                                       kMaxVertexBytes, "vertices");
  if (taken) append(mesh, *object_);
  return taken;
}

void World::finish() {
  for (const auto& [medium, place] : surrounding_) {
    if (filling_.contains(medium)) continue;
    context_.warn(place,
                  fmt::format("the medium '{:.60}' is outside of surfaces and inside of none: "
                              "it is not used",
                              medium));
  }
}

Status World::begin_object(const std::string& name, const std::string& place) {
  if (object_) return fail(Errc::bad_data, place, "an object within another one");
  object_.emplace();
  object_name_ = name;
  return {};
}

Status World::end_object(const std::string& place) {
  if (!object_) return fail(Errc::bad_data, place, "an end without a beginning");
  const auto prototype = context_.import.builder().add_prototype(*object_);
  object_.reset();
  if (!prototype) return tl::unexpected(at_place(prototype.error(), place));
  objects_[object_name_] = *prototype;
  return {};
}

Status World::add_instance(const GraphicsState& state, const std::string& name,
                           const std::string& place) {
  const auto found = objects_.find(name);
  if (found == objects_.end())
    return fail(Errc::bad_data, place, "there is no object of this name");
  if (found->second == kNoPrototype) return {};
  const Transformd to_scene = context_.to_scene * state.to_world;
  Transformf single;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (!(std::fabs(to_scene.rows[i][j]) <= 1e18)) {
        return fail(Errc::bad_data, place, "a number of the transformation is too large");
      }
      single.rows[i][j] = static_cast<float>(to_scene.rows[i][j]);
    }
  }
  if (determinant(single) == 0) {
    return fail(Errc::bad_data, place, "the transformation has no inverse");
  }
  const auto added = context_.import.builder().add_instance(found->second, single);
  if (!added) return tl::unexpected(at_place(added.error(), place));
  return {};
}

}  // namespace dapple::pbrt
