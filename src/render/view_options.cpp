#include "render/view_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include "image/formats.h"
#include "parallel/parallel.h"
#include "scene/prims.h"
#include "util/parse_number.h"

namespace dapple {
namespace {

std::string_view name_of(const NamedCamera& camera) {
  return {camera.name.data(), strnlen(camera.name.data(), camera.name.size())};
}

Vec3d middle_of(const Bounds3f& b) {
  return b.lo.x <= b.hi.x ? 0.5 * (Vec3d(b.lo) + Vec3d(b.hi)) : Vec3d();
}

// On all threads: what takes the time is the system's clearing of new memory.
void copy_bytes(std::span<const std::uint8_t> from, std::uint8_t* to) {
  constexpr std::size_t kBlock = std::size_t{1} << 21;
  parallel_for_dynamic((from.size() + kBlock - 1) / kBlock, [&](std::size_t i) {
    const auto block = from.subspan(i * kBlock, std::min(kBlock, from.size() - i * kBlock));
    std::memcpy(to + i * kBlock, block.data(), block.size());
  });
}

// Light that is not a number or without end would be everywhere.
Status check_finite(const Image& image, const std::string& path) {
  const auto width = static_cast<std::size_t>(image.width);
  std::atomic<std::size_t> first = image.pixels.size();
  parallel_for_dynamic(static_cast<std::size_t>(image.height), [&](std::size_t y) {
    for (std::size_t i = y * width; i < (y + 1) * width && i < first; ++i) {
      if (is_finite(image.pixels[i])) continue;
      std::size_t before = first;
      while (i < before && !first.compare_exchange_weak(before, i)) {
      }
    }
  });
  if (first == image.pixels.size()) return {};
  return fail(Errc::bad_data, path,
              fmt::format("the pixel in column {}, row {}, counted from 0 at the top left, is not "
                          "finite",
                          first % width, first / width));
}

}  // namespace

Expected<std::size_t> camera_index(std::span<const NamedCamera> cameras,
                                   const std::string& wanted) {
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (name_of(cameras[i]) == wanted) return i;
  }
  const auto index = parse_integer(wanted, "camera", 0, INT32_MAX);
  if (index && static_cast<std::size_t>(*index) < cameras.size()) {
    return static_cast<std::size_t>(*index);
  }
  if (cameras.empty()) return fail(Errc::usage, wanted, "the scene has no cameras of its own");
  std::vector<std::string_view> names;
  for (const NamedCamera& camera : cameras) {
    if (!name_of(camera).empty()) names.push_back(name_of(camera));
  }
  const std::string indices = fmt::format("0 to {}", cameras.size() - 1);
  return fail(Errc::usage, wanted,
              names.empty() ? fmt::format("no such camera; there are {}, without names", indices)
                            : fmt::format("no such camera; there are {} (or {})",
                                          fmt::join(names, ", "), indices));
}

Expected<EditedView> EditedView::create(const SceneView& scene, const ViewOptions& options,
                                        double width_over_height) {
  EditedView edited;
  edited.view_ = scene;
  if (auto status = edited.choose_camera(options, width_over_height).and_then([&] {
        return edited.choose_environment(options);
      });
      !status) {
    return tl::unexpected(status.error());
  }
  return edited;
}

Status EditedView::choose_camera(const ViewOptions& options, double width_over_height) {
  if (!options.camera.empty()) {
    const auto index = camera_index(view_.cameras, options.camera);
    if (!index) return tl::unexpected(index.error());
    view_.camera = view_.cameras[*index].camera;
  } else if (options.orbit || options.target) {
    const Orbit orbit = options.orbit.value_or(Orbit());
    const Vec3d target = options.target ? *options.target : middle_of(scene_bounds(view_));
    view_.camera = orbit_camera(orbit, target, options.fov.value_or(kFramingFov));
  } else if (options.frame) {
    view_.camera =
        frame_scene(scene_bounds(view_), width_over_height, options.fov.value_or(kFramingFov));
  }
  if (options.fov) {
    view_.camera.vertical_fov = *options.fov;
    view_.camera.orthographic_height = 0;
  }
  return {};
}

Status EditedView::choose_environment(const ViewOptions& options) {
  Environment& environment = view_.environment;
  if (options.environment == "studio" || options.environment == "none") {
    environment = Environment();
    environment.kind =
        options.environment == "studio" ? EnvironmentKind::studio : EnvironmentKind::none;
  } else if (!options.environment.empty()) {
    if (auto status = load_environment(options.environment); !status) return status;
  }
  if (options.rotation) {
    environment.rotation = static_cast<float>(std::fmod(*options.rotation, 360.0));
  }
  return {};
}

// The scene's images with one more behind them.
Status EditedView::load_environment(const std::string& path) {
  auto image = read_image(path);
  if (!image) return tl::unexpected(image.error());
  if (auto status = check_finite(*image, path); !status) return status;
  images_.assign(view_.images.begin(), view_.images.end());
  TextureImage entry;
  entry.width = static_cast<std::uint32_t>(image->width);
  entry.height = static_cast<std::uint32_t>(image->height);
  entry.format = TexelFormat::rgb32f;
  entry.offset = (view_.texels.size() + 15) / 16 * 16;
  texels_ = HugeArray<std::uint8_t>(entry.offset + entry.bytes());
  copy_bytes(view_.texels, texels_.data());
  copy_bytes({reinterpret_cast<const std::uint8_t*>(image->pixels.data()), entry.bytes()},
             texels_.data() + entry.offset);
  images_.push_back(entry);
  view_.images = images_;
  view_.texels = texels_.span();
  view_.environment = Environment();
  view_.environment.kind = EnvironmentKind::image;
  view_.environment.image = static_cast<ImageId>(images_.size() - 1);
  return {};
}

}  // namespace dapple
