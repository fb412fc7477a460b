#include "accel/accel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "accel/linear_accel.h"
#include "accel/locate.h"
#include "accel/median_accel.h"
#include "accel/wide_accel.h"

namespace dapple {
namespace {

constexpr std::array<std::string_view, 3> kAccelNames = {"linear", "median", "fast"};

}  // namespace

Hit Accel::intersect(const Ray& ray) const {
  Hit hit;
  intersect(std::span(&ray, 1), std::span(&hit, 1));
  return hit;
}

bool Accel::occluded(const Ray& ray) const {
  std::uint8_t result = 0;
  occluded(std::span(&ray, 1), std::span(&result, 1));
  return result != 0;
}

SurfacePoint Accel::locate(const Ray& ray, const Hit& hit) const {
  return locate_hit(leaves_, instances_, ray, hit.t, hit.lane);
}

std::string_view accel_name(AccelKind kind) { return kAccelNames[static_cast<std::size_t>(kind)]; }

Expected<AccelKind> parse_accel_kind(std::string_view name) {
  for (std::size_t i = 0; i < kAccelNames.size(); ++i) {
    if (kAccelNames[i] == name) return static_cast<AccelKind>(i);
  }
  return fail(
      Errc::usage, std::string(name),
      fmt::format("unknown acceleration structure; there are {}", fmt::join(kAccelNames, ", ")));
}

std::string_view bvh_quality_name(BvhQuality quality) {
  return kBvhQualityNames[static_cast<std::size_t>(quality)];
}

Expected<BvhQuality> parse_bvh_quality(std::string_view name) {
  for (std::size_t i = 0; i < kBvhQualityNames.size(); ++i) {
    if (kBvhQualityNames[i] == name) return static_cast<BvhQuality>(i);
  }
  return fail(Errc::usage, std::string(name),
              fmt::format("unknown quality; there are {}", fmt::join(kBvhQualityNames, ", ")));
}

std::unique_ptr<Accel> make_accel(AccelKind kind, const SceneView& scene, BvhQuality quality,
                                  LeafForm form) {
  switch (kind) {
    case AccelKind::linear:
      return std::make_unique<LinearAccel>(scene);
    case AccelKind::median:
      return std::make_unique<MedianAccel>(scene);
    case AccelKind::fast:
      break;
  }
  return std::make_unique<WideAccel>(scene, quality, form);
}

}  // namespace dapple
