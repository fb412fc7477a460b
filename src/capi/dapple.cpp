// The C++ interface. dapple::v0 is what users see as dapple, dapple:: is the library inside.
#define DAPPLE_API_NAMESPACE namespace v0
#include "dapple/dapple.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>

#include "accel/wide_builder.h"
#include "image/formats.h"
#include "render/render_job.h"
#include "scene/validate.h"
#include "scene_file/scene_source.h"
#include "scene_file/writer.h"

namespace dapple::v0 {
namespace {

namespace lib = ::dapple;

Error to_error(const lib::Error& error) {
  return {static_cast<int>(error.code), lib::to_string(error)};
}
Error to_error(lib::Errc code, const char* message) { return {static_cast<int>(code), message}; }

// Runs `call` and turns what it throws into what it would have returned.
template <class Call>
auto guarded(Call&& call) noexcept -> decltype(call()) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    return to_error(lib::Errc::memory, "out of memory");
  } catch (const std::exception& e) {
    return to_error(lib::Errc::internal, e.what());
  } catch (...) {
    return to_error(lib::Errc::internal, "unknown error");
  }
}

Status to_status(const lib::Status& status) {
  return status ? Status() : Status(to_error(status.error()));
}

Vec3d to_vec3(const Point& p) { return {p.x, p.y, p.z}; }
Vec3d to_vec3(const Colour& c) { return {c.r, c.g, c.b}; }
Point to_point(const Vec3d& v) { return {v.x, v.y, v.z}; }

lib::Camera to_lib(const Camera& c) {
  return {to_vec3(c.look_from), to_vec3(c.look_at), to_vec3(c.up),
          c.vertical_fov,       c.aperture,         c.focus_distance};
}
Camera from_lib(const lib::Camera& c) {
  return {to_point(c.look_from), to_point(c.look_at), to_point(c.up),
          c.vertical_fov,        c.aperture,          c.focus_distance};
}

lib::Material to_lib(const Material& material) {
  if (const auto* lambertian = std::get_if<Lambertian>(&material)) {
    return lib::Lambertian{to_vec3(lambertian->albedo)};
  }
  if (const auto* metal = std::get_if<Metal>(&material)) {
    return lib::Metal{to_vec3(metal->albedo), metal->fuzz};
  }
  return lib::Dielectric{std::get<Dielectric>(material).ref_idx};
}

lib::Scene copy_of(const SceneView& view) {
  lib::Scene scene;
  scene.camera = view.camera;
  scene.materials.assign(view.materials.begin(), view.materials.end());
  scene.runs.assign(view.runs.begin(), view.runs.end());
  scene.spheres.assign(view.spheres.begin(), view.spheres.end());
  scene.sphere_materials.assign(view.sphere_materials.begin(), view.sphere_materials.end());
  for (std::size_t i = 0; i < kRectangleKindCount; ++i) {
    scene.rectangles[i].assign(view.rectangles[i].begin(), view.rectangles[i].end());
    const auto& ids = view.rectangle_materials[i];
    scene.rectangle_materials[i].assign(ids.begin(), ids.end());
  }
  return scene;
}

}  // namespace

// A scene in memory, or what was opened and has not been changed since.
struct Scene::State {
  lib::Scene scene;
  std::optional<SceneSource> source;

  SceneView view() const { return source ? source->view() : SceneView(scene); }
};

Scene::Scene() noexcept = default;
Scene::Scene(std::shared_ptr<State> state) noexcept : state_(std::move(state)) {}

Result<Scene> Scene::open(const std::string& name_or_path) noexcept {
  return guarded([&]() -> Result<Scene> {
    auto source = SceneSource::open(name_or_path);
    if (!source) return to_error(source.error());
    auto state = std::make_shared<State>();
    state->source.emplace(std::move(*source));
    return Scene(std::move(state));
  });
}

Scene::State& Scene::own_state() {
  if (state_ == nullptr) {
    state_ = std::make_shared<State>();
  } else if (state_->source || state_.use_count() > 1) {
    auto own = std::make_shared<State>();
    own->scene = copy_of(state_->view());
    state_ = std::move(own);
  }
  return *state_;
}

Result<MaterialId> Scene::add_material(const Material& material) noexcept {
  return guarded([&]() -> Result<MaterialId> {
    const lib::Material added = to_lib(material);
    if (auto status = validate(added); !status) return to_error(status.error());
    return static_cast<MaterialId>(own_state().scene.add_material(added));
  });
}

Status Scene::add_sphere(const Point& centre, double radius, MaterialId material) noexcept {
  return guarded([&]() -> Status {
    const Sphere sphere{to_vec3(centre), radius};
    if (!is_valid(sphere)) {
      return to_error(lib::Errc::bad_data, "sphere: a number is not finite or too large");
    }
    lib::Scene& scene = own_state().scene;
    if (static_cast<std::size_t>(material) >= scene.materials.size()) {
      return to_error(lib::Errc::bad_data, "sphere: its material does not exist");
    }
    scene.add_sphere(sphere, static_cast<lib::MaterialId>(material));
    return {};
  });
}

Status Scene::add_rectangle(Shape shape, const Rectangle& r, MaterialId material) noexcept {
  return guarded([&]() -> Status {
    const auto kind = static_cast<std::size_t>(shape);
    if (kind >= kShapeKindCount || !is_rectangle(static_cast<ShapeKind>(kind))) {
      return to_error(lib::Errc::bad_data, "rectangle: not a kind of rectangle");
    }
    const lib::Rectangle rectangle{r.u0, r.u1, r.v0, r.v1, r.k};
    if (!is_valid(rectangle)) {
      return to_error(lib::Errc::bad_data, "rectangle: a number is not finite or too large");
    }
    lib::Scene& scene = own_state().scene;
    if (static_cast<std::size_t>(material) >= scene.materials.size()) {
      return to_error(lib::Errc::bad_data, "rectangle: its material does not exist");
    }
    scene.add_rectangle(static_cast<ShapeKind>(shape), rectangle,
                        static_cast<lib::MaterialId>(material));
    return {};
  });
}

Status Scene::set_camera(const Camera& camera) noexcept {
  return guarded([&]() -> Status {
    const lib::Camera wanted = to_lib(camera);
    if (auto status = validate(wanted); !status) return to_error(status.error());
    own_state().scene.camera = wanted;
    return {};
  });
}

Camera Scene::camera() const noexcept {
  return state_ == nullptr ? Camera() : from_lib(state_->view().camera);
}

std::size_t Scene::object_count() const noexcept {
  return state_ == nullptr ? 0 : state_->view().object_count();
}

Status Scene::save(const std::string& path, Contents contents) const noexcept {
  return guarded([&]() -> Status {
    const State empty;
    SceneView view = (state_ == nullptr ? empty : *state_).view();
    WideBvh built;
    if (contents == Contents::scene) view.bvh = {};
    if (contents == Contents::scene_and_bvh && view.bvh.empty()) {
      built = build_wide_bvh(view);
      view.bvh = built.view();
    }
    return to_status(store_scene_file(path, view));
  });
}

struct Accelerator::State {
  std::shared_ptr<const Scene::State> scene;
  std::array<std::size_t, kShapeKindCount> first_ids;
  std::unique_ptr<PreparedScene> prepared;

  Hit to_hit(const lib::Hit& hit) const {
    if (!hit.found()) return {};
    const ShapeKind kind = hit.lane.kind();
    const std::size_t index = hit.prim - first_ids[static_cast<std::size_t>(kind)];
    return {hit.t, static_cast<Shape>(kind), static_cast<std::uint32_t>(index)};
  }
};

Accelerator::Accelerator(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

Result<Accelerator> Accelerator::build(const Scene& scene, Kind kind) noexcept {
  return guarded([&]() -> Result<Accelerator> {
    auto state = std::make_shared<State>();
    state->scene = scene.state_ ? scene.state_ : std::make_shared<Scene::State>();
    const SceneView view = state->scene->view();
    state->first_ids = first_prim_ids(view);
    state->prepared =
        std::make_unique<PreparedScene>(view, make_accel(static_cast<AccelKind>(kind), view));
    return Accelerator(std::move(state));
  });
}

namespace {

// Rays go in and hits come out in pieces that fit the first-level cache.
constexpr std::size_t kPiece = 256;
static_assert(sizeof(Ray) == sizeof(lib::Ray) &&
              offsetof(Ray, t_min) == offsetof(lib::Ray, t_min) &&
              offsetof(Ray, t_max) == offsetof(lib::Ray, t_max));

template <class Body>
void for_each_piece(std::span<const Ray> rays, Body&& body) {
  std::array<lib::Ray, kPiece> piece;
  for (std::size_t begin = 0; begin < rays.size(); begin += kPiece) {
    const std::size_t count = std::min(kPiece, rays.size() - begin);
    std::memcpy(static_cast<void*>(piece.data()), rays.data() + begin, count * sizeof(Ray));
    body(begin, std::span<const lib::Ray>(piece).first(count));
  }
}

constexpr const char* kLengthsDiffer = "rays and results differ in number";

}  // namespace

Status Accelerator::intersect(std::span<const Ray> rays, std::span<Hit> hits) const noexcept {
  return guarded([&]() -> Status {
    if (rays.size() != hits.size()) return to_error(lib::Errc::usage, kLengthsDiffer);
    std::array<lib::Hit, kPiece> found;
    for_each_piece(rays, [&](std::size_t begin, std::span<const lib::Ray> piece) {
      state_->prepared->accel().intersect(piece, std::span(found).first(piece.size()));
      for (std::size_t i = 0; i < piece.size(); ++i) hits[begin + i] = state_->to_hit(found[i]);
    });
    return {};
  });
}

Status Accelerator::occluded(std::span<const Ray> rays,
                             std::span<std::uint8_t> results) const noexcept {
  return guarded([&]() -> Status {
    if (rays.size() != results.size()) return to_error(lib::Errc::usage, kLengthsDiffer);
    for_each_piece(rays, [&](std::size_t begin, std::span<const lib::Ray> piece) {
      state_->prepared->accel().occluded(piece, results.subspan(begin, piece.size()));
    });
    return {};
  });
}

Result<Picture> render(const Accelerator& accelerator, const RenderOptions& options) noexcept {
  return guarded([&]() -> Result<Picture> {
    RenderSettings settings;
    settings.width = options.width;
    settings.height = options.height;
    settings.samples_per_pixel = options.samples_per_pixel;
    settings.seed = options.seed;
    const auto result = lib::render(*accelerator.state_->prepared, settings);
    if (!result) return to_error(result.error());
    Picture picture{result->image.width, result->image.height, {}};
    picture.rgb.reserve(3 * result->image.pixels.size());
    for (const Vec3f& p : result->image.pixels)
      picture.rgb.insert(picture.rgb.end(), {p.x, p.y, p.z});
    return picture;
  });
}

Status Picture::save(const std::string& path) const noexcept {
  return guarded([&]() -> Status {
    const auto pixels = static_cast<std::size_t>(std::max(width, 0)) *
                        static_cast<std::size_t>(std::max(height, 0));
    if (pixels == 0 || rgb.size() != 3 * pixels) {
      return to_error(lib::Errc::usage, "the picture's numbers do not fit its size");
    }
    Image image(width, height);
    for (std::size_t i = 0; i < pixels; ++i) {
      image.pixels[i] = {rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]};
    }
    return to_status(write_image(path, image, {}));
  });
}

}  // namespace dapple::v0
