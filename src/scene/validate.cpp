#include "scene/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dapple {
namespace {

bool is_coordinate(double value) { return std::fabs(value) <= kMaxCoordinate; }  // false for NaN

bool is_point(const Vec3d& p) {
  return is_coordinate(p.x) && is_coordinate(p.y) && is_coordinate(p.z);
}

bool shape_is_valid(const SceneView& scene, ShapeKind kind, std::size_t index) {
  if (kind == ShapeKind::sphere) return is_valid(scene.spheres[index]);
  return !is_rectangle(kind) || is_valid(scene.rectangles[rectangle_index(kind)][index]);
}

std::string object_place(std::size_t number) { return fmt::format("object {}", number); }

Status check_objects(const SceneView& scene) {
  Status status;
  std::size_t position = 0;
  for_each_object(scene, [&](ShapeKind kind, std::size_t index) {
    if (!status) return;
    const std::size_t number = position++;
    if (kind != ShapeKind::instance &&
        index_of(scene.materials_of(kind)[index]) >= scene.materials.size()) {
      status = fail(Errc::bad_data, object_place(number), "its material does not exist");
    } else if (!shape_is_valid(scene, kind, index)) {
      status = fail(Errc::bad_data, object_place(number),
                    fmt::format("{} has a coordinate that is not finite or beyond {:g}",
                                shape_name(kind), kMaxCoordinate));
    }
  });
  return status;
}

}  // namespace

bool is_valid(const Sphere& sphere) {
  return is_point(sphere.centre) && is_coordinate(sphere.radius);
}

bool is_valid(const Rectangle& r) {
  return is_coordinate(r.u0) && is_coordinate(r.u1) && is_coordinate(r.v0) && is_coordinate(r.v1) &&
         is_coordinate(r.k);
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

Status validate(const SceneView& scene) {
  if (auto status = validate(scene.camera); !status) return status;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (!validate(scene.materials[i])) {
      return fail(Errc::bad_data, fmt::format("material {}", i), "a number is not finite");
    }
  }
  if (auto status = validate_counts(scene); !status) return status;
  return check_objects(scene);
}

}  // namespace dapple
