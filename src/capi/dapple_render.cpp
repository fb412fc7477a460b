// Rays and pictures of the C++ interface.
#include <algorithm>
#include <array>
#include <cstring>

#include "capi/api_state.h"
#include "image/formats.h"
#include "render/render_job.h"
#include "scene/validate_instances.h"

namespace dapple::v0 {

struct Accelerator::State {
  std::shared_ptr<const Scene::State> scene;
  std::array<std::size_t, kShapeKindCount> first_ids;
  std::unique_ptr<PreparedScene> prepared;

  Hit to_hit(const lib::Hit& hit) const {
    if (!hit.found()) return {};
    const ShapeKind kind = hit.lane.kind();
    const std::size_t index = hit.prim - first_ids[static_cast<std::size_t>(kind)];
    const std::size_t instance = hit.lane.in_instance() ? hit.lane.instance_index() : no_instance;
    return {hit.t, static_cast<Shape>(kind), static_cast<std::uint32_t>(index),
            static_cast<std::uint32_t>(instance)};
  }
};

Accelerator::Accelerator(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

Result<Accelerator> Accelerator::build(const Scene& scene, Kind kind) noexcept {
  return guarded([&]() -> Result<Accelerator> {
    auto state = std::make_shared<State>();
    state->scene = scene.state_ ? scene.state_ : std::make_shared<Scene::State>();
    const SceneView view = state->scene->view();
    // Files are proven when they are opened, and all else when it is added.
    if (!state->scene->source && instance_too_far(view)) {
      return to_error(lib::Errc::bad_data, "instance: it reaches too far");
    }
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
