#include "import/points.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "image/transfer.h"
#include "math/bounds3.h"
#include "scene/validate.h"

namespace dapple {
namespace {

constexpr double kWhite = 0.8;  // of points without a colour

// One material for each display colour of 8 bits.
class PointColours {
 public:
  explicit PointColours(SceneBuilder& builder) : builder_(builder) {}

  MaterialId material(const Vec4f& colour) {
    const std::uint32_t key = channel(colour.x) << 16 | channel(colour.y) << 8 | channel(colour.z);
    const auto [at, is_new] = materials_.try_emplace(key);
    if (is_new) {
      at->second = builder_.add_classic(
          Lambertian{{linear_[key >> 16], linear_[key >> 8 & 255], linear_[key & 255]}});
    }
    return at->second;
  }

 private:
  static std::uint32_t channel(float linear) { return encode_integer(linear, Transfer::srgb, 255); }

  SceneBuilder& builder_;
  std::vector<float> linear_ = decode_table(255, Transfer::srgb);
  std::unordered_map<std::uint32_t, MaterialId> materials_;
};

bool is_shown(const Vec3f& position, double radius) {
  return is_valid(Sphere{Vec3d(position), radius}) && radius > 0;
}

}  // namespace

double default_point_radius(std::span<const Vec3f> positions, std::size_t count) {
  Bounds3f bounds;
  for (const Vec3f& position : positions) {
    if (is_valid(Sphere{Vec3d(position), 1})) bounds.extend({position, position});
  }
  const double extent = length(Vec3d(bounds.hi) - Vec3d(bounds.lo));
  if (!(extent > 0 && std::isfinite(extent))) return 1;
  return 0.5 * extent / std::sqrt(static_cast<double>(std::max<std::size_t>(count, 1)));
}

Expected<std::size_t> add_points(const PointCloud& cloud, SceneBuilder& builder) {
  const std::size_t count = cloud.positions.size();
  if (auto taken = builder.budget().take(count, sizeof(Sphere) + sizeof(MaterialId), "points");
      !taken) {
    return tl::unexpected(taken.error());
  }
  const MaterialId white = builder.add_classic(Lambertian{{kWhite, kWhite, kWhite}});
  PointColours colours(builder);
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = cloud.radii.empty() ? cloud.radius : double(cloud.radii[i]);
    if (!is_shown(cloud.positions[i], radius)) {
      ++left_out;
      continue;
    }
    builder.add_sphere(Vec3d(cloud.positions[i]), radius,
                       cloud.colours.empty() ? white : colours.material(cloud.colours[i]));
  }
  return left_out;
}

}  // namespace dapple
