#include "scene/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "parallel/parallel.h"
#include "scene/array_checks.h"
#include "scene/validate_instances.h"
#include "scene/validate_looks.h"

namespace dapple {
namespace {

bool is_coordinate(double value) { return std::fabs(value) <= kMaxCoordinate; }  // false for NaN

bool is_point(const Vec3d& p) {
  return is_coordinate(p.x) && is_coordinate(p.y) && is_coordinate(p.z);
}

std::optional<ShapeKind> object_kind(SceneArray array) {
  switch (array) {
    case SceneArray::spheres:
    case SceneArray::sphere_materials:
      return ShapeKind::sphere;
    case SceneArray::xy_rectangles:
    case SceneArray::xy_rectangle_materials:
      return ShapeKind::xy_rectangle;
    case SceneArray::xz_rectangles:
    case SceneArray::xz_rectangle_materials:
      return ShapeKind::xz_rectangle;
    case SceneArray::yz_rectangles:
    case SceneArray::yz_rectangle_materials:
      return ShapeKind::yz_rectangle;
    case SceneArray::cylinders:
    case SceneArray::cylinder_materials:
      return ShapeKind::cylinder;
    case SceneArray::instances:
      return ShapeKind::instance;
    default:
      return std::nullopt;
  }
}

// The number in stored order of shape `index` of a kind.
std::uint64_t object_number(const SceneView& scene, ShapeKind kind, std::uint64_t index) {
  std::uint64_t number = 0;
  for (const ObjectRun& run : scene.runs) {
    if (run.kind == kind) {
      if (index < run.count) return number + index;
      index -= run.count;
    }
    number += run.count;
  }
  return number;
}

tl::unexpected<Error> invalid_element(const SceneView& scene, const ArrayLimits& limits,
                                      SceneArray array, std::size_t index) {
  const std::string why = why_invalid(scene, limits, array, index);
  if (const auto kind = object_kind(array)) {
    return fail(Errc::bad_data, fmt::format("object {}", object_number(scene, *kind, index)),
                fmt::format("{}: {}", element_name(array), why));
  }
  return fail(Errc::bad_data, fmt::format("{} {}", element_name(array), index), why);
}

// Pieces of all arrays.
struct Piece {
  SceneArray array;
  std::size_t begin, end;
};

std::vector<Piece> pieces_of(const SceneView& scene) {
  constexpr std::size_t kPieceSize = 1 << 15;
  std::vector<Piece> pieces;
  for_each_array(
      [&](SceneArray array, const auto& elements) {
        if (array == SceneArray::texels) return;  // any byte will do
        for (std::size_t begin = 0; begin < elements.size(); begin += kPieceSize) {
          pieces.push_back({array, begin, std::min(begin + kPieceSize, elements.size())});
        }
      },
      scene);
  return pieces;
}

Status validate_arrays(const SceneView& scene) {
  constexpr std::size_t kTooFewForThreads = 64;
  const ArrayLimits limits(scene, scene.materials.size());
  const std::vector<Piece> pieces = pieces_of(scene);
  std::vector<std::size_t> found(pieces.size());
  const auto check = [&](std::size_t i) {
    const Piece& piece = pieces[i];
    found[i] = first_invalid(scene, limits, piece.array, piece.begin, piece.end);
  };
  if (pieces.size() < kTooFewForThreads) {
    for (std::size_t i = 0; i < pieces.size(); ++i) check(i);
  } else {
    parallel_for_dynamic(pieces.size(), check);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (found[i] != pieces[i].end) return invalid_element(scene, limits, pieces[i].array, found[i]);
  }
  return {};
}

Status validate_materials(const SceneView& scene) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const auto bad = [&](const char* reason) {
      return fail(Errc::bad_data, fmt::format("material {}", i), reason);
    };
    if (!validate(scene.materials[i])) return bad("a number is not finite");
    const auto* layered = std::get_if<Layered>(&scene.materials[i]);
    if (layered != nullptr && layered->index >= scene.layered_materials.size()) {
      return bad("its layered material does not exist");
    }
  }
  return {};
}

Status validate_runs(const SceneView& scene) {
  std::array<std::uint64_t, kShapeKindCount> in_runs{};
  std::uint64_t total = 0;
  for (const ObjectRun& run : scene.runs) {
    const auto kind = static_cast<std::size_t>(run.kind);
    if (kind >= kShapeKindCount) return fail(Errc::bad_data, "objects", "unknown object type");
    if (run.count > kMaxObjectCount - total) {
      return fail(Errc::bad_data, "objects", fmt::format("more than {} objects", kMaxObjectCount));
    }
    total += run.count;
    in_runs[kind] += run.count;
  }
  for (std::size_t kind = 0; kind < kShapeKindCount; ++kind) {
    const auto shape_kind = static_cast<ShapeKind>(kind);
    const std::size_t material_count =
        shape_kind == ShapeKind::instance ? 0 : scene.count(shape_kind);
    if (in_runs[kind] != scene.object_count(shape_kind) ||
        scene.materials_of(shape_kind).size() != material_count) {
      return fail(Errc::bad_data, "objects",
                  fmt::format("the counts of {} objects disagree", shape_name(shape_kind)));
    }
  }
  return {};
}

Status validate_vertex_counts(const VertexView& vertices) {
  const auto fits = [&](const auto& array) {
    return array.empty() || array.size() == vertices.positions.size();
  };
  const bool all_fit = fits(vertices.normals) && fits(vertices.tangents) &&
                       fits(vertices.colours) &&
                       std::all_of(vertices.uvs.begin(), vertices.uvs.end(), fits);
  if (all_fit) return {};
  return fail(Errc::bad_data, "vertices", "attributes and positions differ in number");
}

}  // namespace

bool is_valid(const Sphere& sphere) {
  return is_point(sphere.centre) && is_coordinate(sphere.radius);
}

bool is_valid(const Rectangle& r) {
  return is_coordinate(r.u0) && is_coordinate(r.u1) && is_coordinate(r.v0) && is_coordinate(r.v1) &&
         is_coordinate(r.k);
}

bool is_valid(const Cylinder& c) {
  return is_point(c.begin) && is_point(c.end) && is_coordinate(c.radius) && c.radius >= 0;
}

Status validate(const Camera& camera) {
  const auto bad = [](const char* reason) { return fail(Errc::bad_data, "camera", reason); };
  if (!is_point(camera.look_from) || !is_point(camera.look_at) || !is_point(camera.up)) {
    return bad("a coordinate is not finite or too large");
  }
  if (!(camera.vertical_fov > 0 && camera.vertical_fov < 180)) {
    return bad("the vertical field of view is not between 0 and 180 degrees");
  }
  if (!(camera.aperture >= 0 && camera.aperture <= kMaxCoordinate)) {
    return bad("the aperture is negative, not finite or too large");
  }
  if (!(camera.focus_distance > 0 && camera.focus_distance <= kMaxCoordinate)) {
    return bad("the focus distance is not positive, not finite or too large");
  }
  if (!(camera.orthographic_height >= 0 && camera.orthographic_height <= kMaxCoordinate)) {
    return bad("the orthographic height is negative, not finite or too large");
  }
  return {};
}

Status validate(const Material& material) {
  const bool finite = std::visit(
      [](const auto& m) {
        if constexpr (requires { m.index; }) {
          return true;
        } else if constexpr (requires { m.ref_idx; }) {
          return std::isfinite(m.ref_idx);
        } else if constexpr (requires { m.fuzz; }) {
          return is_finite(m.albedo) && std::isfinite(m.fuzz);
        } else {
          return is_finite(m.albedo);
        }
      },
      material);
  if (!finite) return fail(Errc::bad_data, "material", "a number is not finite");
  return {};
}

Status validate_counts(const SceneView& scene) {
  if (prim_count(scene) > kMaxObjectCount) {
    return fail(Errc::bad_data, "objects",
                fmt::format("more than {} objects and triangles", kMaxObjectCount));
  }
  if (scene.materials.size() > kMaxMaterialCount) {
    return fail(Errc::bad_data, "materials", fmt::format("more than {}", kMaxMaterialCount));
  }
  if (scene.instances.size() > kMaxInstanceCount) {
    return fail(Errc::bad_data, "instances", fmt::format("more than {}", kMaxInstanceCount));
  }
  if (!scene.prototypes.empty() && scene.prototypes[0].first_triangle > scene.triangles.size()) {
    return fail(Errc::bad_data, "prototype 0", "it begins beyond the last triangle");
  }
  if (scene.images.empty() && !scene.texels.empty()) {
    return fail(Errc::bad_data, "texels", "they are of no image");
  }
  if (auto status = validate_vertex_counts(scene.vertices); !status) return status;
  return validate_runs(scene);
}

Status validate(const SceneView& scene) {
  if (auto status = validate(scene.camera); !status) return status;
  const std::string reason = reason_against(scene.environment, scene.images.size());
  if (!reason.empty()) return fail(Errc::bad_data, "environment", reason);
  if (auto status = validate_counts(scene); !status) return status;
  if (auto status = validate_materials(scene); !status) return status;
  if (auto status = validate_arrays(scene); !status) return status;
  if (const auto index = instance_too_far(scene)) {
    return fail(Errc::bad_data,
                fmt::format("object {}", object_number(scene, ShapeKind::instance, *index)),
                fmt::format("instance: it reaches beyond {:g}", kMaxCoordinate));
  }
  return {};
}

}  // namespace dapple
