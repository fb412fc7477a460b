#include "dapple/scene_io.h"

#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <unordered_map>
#include <vector>

#include "capi/last_error.h"
#include "scene/validate.h"
#include "scene_file/mapped_scene.h"
#include "scene_file/writer.h"

// The names of the C interface are those of the global namespace, ours those of dapple.
struct loaded_scene {
  std::vector<material> materials;
  std::vector<object> objects;
  vec lookfrom;
  vec lookat;
};

namespace dapple {
namespace {

Vec3d to_vec3(const vec& v) { return {v.x, v.y, v.z}; }
vec to_vec(const Vec3d& v) { return {v.x, v.y, v.z}; }

// A tag as it lies in memory: what a caller stored in an enum need not be one of its names.
template <class Enum>
unsigned tag_of(const Enum& type) {
  static_assert(sizeof(Enum) == sizeof(unsigned));
  unsigned tag;
  std::memcpy(&tag, &type, sizeof(tag));
  return tag;
}

std::string object_place(std::size_t number) { return fmt::format("object {}", number); }

Expected<Material> to_material(const material& m) {
  switch (tag_of(m.type)) {
    case LAMBERTIAN:
      return Lambertian{to_vec3(m.lambertian.albedo)};
    case METAL:
      return Metal{to_vec3(m.metal.albedo), m.metal.fuzz};
    case DIELECTRIC:
      return Dielectric{m.dielectric.ref_idx};
    default:
      return fail(Errc::bad_data, "", "its material is of no known type");
  }
}

// Gathers objects into a scene; materials are told apart by where they are.
class Collector {
 public:
  explicit Collector(Scene& scene) : scene_(scene) {}

  Status add(const object& o) {
    switch (tag_of(o.type)) {
      case SPHERE:
        return add_sphere(o.sphere);
      case XY_RECTANGLE: {
        const auto& r = o.xy_rectangle;
        return add_rectangle(ShapeKind::xy_rectangle, {r.x0, r.x1, r.y0, r.y1, r.k}, r.material);
      }
      case XZ_RECTANGLE: {
        const auto& r = o.xz_rectangle;
        return add_rectangle(ShapeKind::xz_rectangle, {r.x0, r.x1, r.z0, r.z1, r.k}, r.material);
      }
      case YZ_RECTANGLE: {
        const auto& r = o.yz_rectangle;
        return add_rectangle(ShapeKind::yz_rectangle, {r.y0, r.y1, r.z0, r.z1, r.k}, r.material);
      }
      default:
        return fail(Errc::bad_data, "", "it is of no known type");
    }
  }

 private:
  Status add_sphere(const sphere& s) {
    const auto id = material_id(s.material);
    if (!id) return tl::unexpected(id.error());
    scene_.add_sphere({to_vec3(s.centre), s.radius}, *id);
    return {};
  }

  Status add_rectangle(ShapeKind kind, const Rectangle& rectangle, const material* m) {
    const auto id = material_id(m);
    if (!id) return tl::unexpected(id.error());
    scene_.add_rectangle(kind, rectangle, *id);
    return {};
  }

  Expected<MaterialId> material_id(const material* m) {
    if (m == nullptr) return fail(Errc::bad_data, "", "its material is NULL");
    if (m == last_) return last_id_;
    const auto known = ids_.find(m);
    if (known == ids_.end()) {
      const auto added = to_material(*m);
      if (!added) return tl::unexpected(added.error());
      last_id_ = ids_.emplace(m, scene_.add_material(*added)).first->second;
    } else {
      last_id_ = known->second;
    }
    last_ = m;
    return last_id_;
  }

  Scene& scene_;
  std::unordered_map<const material*, MaterialId> ids_;
  const material* last_ = nullptr;
  MaterialId last_id_{};
};

Status store(const char* path, std::size_t count, const object* objects, const vec& lookfrom,
             const vec& lookat) {
  if (path == nullptr) return fail(Errc::usage, "", "the file's name is NULL");
  if (objects == nullptr && count > 0) return fail(Errc::usage, path, "the objects are NULL");
  if (count > kMaxObjectCount) {
    return fail(Errc::bad_data, path, fmt::format("more than {} objects", kMaxObjectCount));
  }
  Scene scene;
  scene.camera.look_from = to_vec3(lookfrom);
  scene.camera.look_at = to_vec3(lookat);
  Collector collector(scene);
  for (std::size_t i = 0; i < count; ++i) {
    if (auto status = collector.add(objects[i]); !status) {
      return fail(status.error().code, path, object_place(i) + ": " + status.error().message);
    }
  }
  if (auto status = validate(scene); !status) {
    return fail(status.error().code, path, to_string(status.error()));
  }
  return store_scene_file(path, scene);
}

material to_c(const Material& from) {
  material m{};
  if (const auto* lambertian_ = std::get_if<Lambertian>(&from)) {
    m.type = LAMBERTIAN;
    m.lambertian.albedo = to_vec(lambertian_->albedo);
  } else if (const auto* metal_ = std::get_if<Metal>(&from)) {
    m.type = METAL;
    m.metal = {to_vec(metal_->albedo), metal_->fuzz};
  } else {
    m.type = DIELECTRIC;
    m.dielectric.ref_idx = std::get<Dielectric>(from).ref_idx;
  }
  return m;
}

object to_c(const SceneView& scene, ShapeKind kind, std::size_t index, material* materials) {
  object o{};
  material* m = materials + index_of(scene.materials_of(kind)[index]);
  o.type = static_cast<OBJECT_TYPE>(kind);
  if (kind == ShapeKind::sphere) {
    const Sphere& s = scene.spheres[index];
    o.sphere = {to_vec(s.centre), s.radius, m};
    return o;
  }
  const Rectangle& r = scene.rectangles[rectangle_index(kind)][index];
  if (kind == ShapeKind::xy_rectangle) o.xy_rectangle = {r.u0, r.u1, r.v0, r.v1, r.k, m};
  if (kind == ShapeKind::xz_rectangle) o.xz_rectangle = {r.u0, r.u1, r.v0, r.v1, r.k, m};
  if (kind == ShapeKind::yz_rectangle) o.yz_rectangle = {r.u0, r.u1, r.v0, r.v1, r.k, m};
  return o;
}
static_assert(SPHERE == static_cast<int>(ShapeKind::sphere) &&
              XY_RECTANGLE == static_cast<int>(ShapeKind::xy_rectangle) &&
              XZ_RECTANGLE == static_cast<int>(ShapeKind::xz_rectangle) &&
              YZ_RECTANGLE == static_cast<int>(ShapeKind::yz_rectangle));

// Why a scene has no form in these structs; null when it has.
const char* reason_not_expressible(const SceneView& scene) {
  if (scene.count(ShapeKind::triangle) > 0) return "it has triangles";
  if (scene.count(ShapeKind::cylinder) > 0) return "it has cylinders";
  if (scene.count(ShapeKind::instance) > 0) return "it has instances";
  for (const Material& m : scene.materials) {
    if (std::holds_alternative<Layered>(m)) return "it has layered materials";
  }
  if (!scene.lights.empty()) return "it has lights";
  if (!(scene.environment == Environment())) return "it has an environment of its own";
  if (scene.camera.orthographic_height > 0) return "its camera is orthographic";
  return nullptr;
}

Expected<std::unique_ptr<loaded_scene>> load(const char* path) {
  if (path == nullptr) return fail(Errc::usage, "", "the file's name is NULL");
  const auto file = MappedScene::open(path);
  if (!file) return tl::unexpected(file.error());
  const SceneView& view = file->view();
  if (const char* reason = reason_not_expressible(view)) {
    return fail(Errc::bad_data, path,
                fmt::format("{}, for which the C interface has no structs", reason));
  }
  auto scene = std::make_unique<loaded_scene>();
  scene->lookfrom = to_vec(view.camera.look_from);
  scene->lookat = to_vec(view.camera.look_at);
  scene->materials.reserve(view.materials.size());
  for (const Material& m : view.materials) scene->materials.push_back(to_c(m));
  scene->objects.reserve(view.object_count());
  for_each_object(view, [&](ShapeKind kind, std::size_t index) {
    scene->objects.push_back(to_c(view, kind, index, scene->materials.data()));
  });
  return scene;
}

// Nothing may leave through the C border but a result and a reason.
template <class Call, class Result>
Result guarded(Call&& call, Result on_failure) noexcept {
  set_last_error("");
  try {
    auto result = call();
    if (result) {
      if constexpr (std::is_same_v<decltype(result), Status>) {
        return Result{};
      } else {
        return result->release();
      }
    }
    set_last_error(to_string(result.error()));
  } catch (const std::bad_alloc&) {
    set_last_error("out of memory");
  } catch (const std::exception& e) {
    set_last_error(e.what());
  } catch (...) {
    set_last_error("unknown error");
  }
  return on_failure;
}

}  // namespace
}  // namespace dapple

int store_scene(char* fname, size_t num_objects, object* objects, vec lookfrom, vec lookat) {
  return dapple::guarded(
      [&] { return dapple::store(fname, num_objects, objects, lookfrom, lookat); }, 1);
}

loaded_scene* load_scene(const char* fname) {
  return dapple::guarded([&] { return dapple::load(fname); }, static_cast<loaded_scene*>(nullptr));
}

size_t scene_get_num_objects(loaded_scene* scene) {
  return scene == nullptr ? 0 : scene->objects.size();
}

object* scene_get_objects(loaded_scene* scene) {
  return scene == nullptr ? nullptr : scene->objects.data();
}

vec* scene_get_lookfrom(loaded_scene* scene) {
  return scene == nullptr ? nullptr : &scene->lookfrom;
}

vec* scene_get_lookat(loaded_scene* scene) { return scene == nullptr ? nullptr : &scene->lookat; }

void free_loaded_scene(loaded_scene* scene) { delete scene; }

const char* scene_io_last_error(void) { return dapple::last_error(); }
