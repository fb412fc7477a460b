// Scenes of the C++ interface: opening, saving, and what every scene has.
#include "accel/wide_builder.h"
#include "capi/api_state.h"
#include "render/scene_input.h"
#include "scene/scene_arrays.h"
#include "scene/validate.h"
#include "scene_file/writer.h"

namespace dapple::v0 {
namespace {

lib::Camera to_lib(const Camera& c) {
  return {to_vec3(c.look_from), to_vec3(c.look_at), to_vec3(c.up),        c.vertical_fov,
          c.aperture,           c.focus_distance,   c.orthographic_height};
}
Camera from_lib(const lib::Camera& c) {
  return {to_point(c.look_from), to_point(c.look_at),  to_point(c.up), c.vertical_fov, c.aperture,
          c.focus_distance,      c.orthographic_height};
}

}  // namespace

Scene::Scene() noexcept = default;
Scene::Scene(std::shared_ptr<State> state) noexcept : state_(std::move(state)) {}

Result<Scene> Scene::open(const std::string& name_or_path) noexcept {
  return guarded([&]() -> Result<Scene> {
    auto input = open_scene_input(name_or_path);
    if (!input) return to_error(input.error());
    auto state = std::make_shared<State>();
    state->source.emplace(std::move(input->source));
    state->pictures = std::move(input->pictures);
    return Scene(std::move(state));
  });
}

Scene::State& Scene::own_state() {
  if (state_ == nullptr) {
    state_ = std::make_shared<State>();
  } else if (state_->source || state_.use_count() > 1) {
    auto own = std::make_shared<State>();
    own->scene = copy_of(state_->view());
    own->pictures = state_->pictures;
    state_ = std::move(own);
  }
  return *state_;
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
    const State& state = state_ == nullptr ? empty : *state_;
    SceneView view = state.view();
    WideBvh built;
    if (contents == Contents::scene) view.bvh = {};
    if (contents == Contents::scene_and_bvh && view.bvh.empty()) {
      built = build_wide_bvh(view);
      view.bvh = built.view();
    }
    return to_status(store_scene_file(path, view, state.pictures));
  });
}

}  // namespace dapple::v0
