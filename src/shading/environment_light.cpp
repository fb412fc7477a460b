#include "shading/environment_light.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "math/fast_functions.h"
#include "math/warps.h"
#include "parallel/parallel.h"
#include "shading/colour.h"
#include "shading/studio.h"

namespace dapple {
namespace {

constexpr float kUniformPdf = 0.25f * kInvPi;

float fraction(float x) { return x - std::floor(x); }

Vec2f uv_of(const Vec3f& d, float turn) {
  const float u = fast_atan2(d.z, d.x) * (0.5f * kInvPi) + 0.5f + turn;
  return {fraction(u), fast_acos(d.y) * kInvPi};
}

Vec3f direction_of(Vec2f uv, float turn) {
  const SinCos<float> polar = sin_cos_turns(0.5f * uv.y);
  const SinCos<float> around = sin_cos_turns(uv.x - 0.5f - turn);
  return {polar.sin * around.cos, polar.cos, polar.sin * around.sin};
}

// Density over solid angle of a density over the unit square.
float per_solid_angle(float pdf, float sin_polar) {
  return sin_polar > 0.0f ? pdf / (2.0f * kPi * kPi * sin_polar) : 0.0f;
}

float sine_from(float cosine) {
  const float squared = (1.0f - cosine) * (1.0f + cosine);
  return squared > 0.0f ? std::sqrt(squared) : 0.0f;
}

// Of image/rgbe.h, red in the lowest byte.
Vec3f decode_rgbe(std::uint32_t word) {
  const std::uint32_t exponent = word >> 24;
  if (exponent == 0) return {};
  const float step = std::bit_cast<float>((exponent - 9) << 23);
  return {step * static_cast<float>(word & 255), step * static_cast<float>(word >> 8 & 255),
          step * static_cast<float>(word >> 16 & 255)};
}

// False where something would be lost.
bool encode_rgbe(const float* c, std::uint32_t& word) {
  // The step at which the largest channel is an integer in [128, 256), and its exponent.
  const float largest = std::max(std::max(c[0], c[1]), c[2]);
  const std::uint32_t exponent = (std::bit_cast<std::uint32_t>(largest) >> 23) + 2;
  word = 0;
  if (!(largest > 0x1p-110f) || exponent > 255) return c[0] == 0 && c[1] == 0 && c[2] == 0;
  const float inverse = std::bit_cast<float>((127 + 136 - exponent) << 23);
  bool exact = true;
  for (int channel = 0; channel < 3; ++channel) {
    const float scaled = c[channel] * inverse;
    const auto mantissa = static_cast<std::int32_t>(scaled > 0.0f ? scaled : 0.0f);
    exact &= static_cast<float>(mantissa) == scaled;
    word |= static_cast<std::uint32_t>(mantissa) << (8 * channel);
  }
  word |= exponent << 24;
  return exact;
}

constexpr int kMostColumns = 1024, kMostRows = 512;  // of the grid of densities

// Interpolation between texels reaches into neighbouring cells.
std::vector<float> blurred(const std::vector<float>& values, int columns, int rows) {
  std::vector<float> result(values.size());
  const auto at = [&](int x, int y) {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < rows; ++y) {
    const int above = std::max(y - 1, 0), below = std::min(y + 1, rows - 1);
    for (int x = 0; x < columns; ++x) {
      const int left = x > 0 ? x - 1 : columns - 1, right = x + 1 < columns ? x + 1 : 0;
      result[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
             static_cast<std::size_t>(x)] =
          0.7f * at(x, y) + 0.06f * (at(left, y) + at(right, y) + at(x, above) + at(x, below)) +
          0.015f * (at(left, above) + at(right, above) + at(left, below) + at(right, below));
    }
  }
  return result;
}

}  // namespace

EnvironmentLight::EnvironmentLight(const SceneView& scene, const TextureSet& textures)
    : turn_(std::fmod(scene.environment.rotation, 360.0f) / 360.0f),
      colour_(scene.environment.colour) {
  const Environment& environment = scene.environment;
  black_ = environment.kind == EnvironmentKind::none || !(max_component(colour_) > 0);
  if (black_) return;
  mean_ = colour_;
  if (environment.kind == EnvironmentKind::studio) {
    own_pixels_ = studio_pixels();
    use_own_pixels(kStudioWidth, kStudioHeight);
  } else if (environment.kind == EnvironmentKind::image && environment.image != kNoImage) {
    use_image(scene, textures);
  }
  if (!is_uniform()) build_distribution();
}

void EnvironmentLight::use_own_pixels(int width, int height) {
  static_assert(sizeof(Vec3f) == 12);
  width_ = width, height_ = height;
  rgb_ = reinterpret_cast<const std::uint8_t*>(own_pixels_.data());
}

void EnvironmentLight::use_image(const SceneView& scene, const TextureSet& textures) {
  const ImageId id = scene.environment.image;
  const TextureImage& image = scene.images[static_cast<std::size_t>(id)];
  const auto width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  if (image.format == TexelFormat::rgb32f) {
    width_ = width, height_ = height;
    rgb_ = scene.texels.data() + image.offset;
    pack();
    return;
  }
  own_pixels_.reserve(std::size_t{image.width} * image.height);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      own_pixels_.push_back(textures.texel(id, true, x, y).xyz());
    }
  }
  use_own_pixels(width, height);
}

Vec3f EnvironmentLight::texel(int x, int y) const {
  const std::size_t index =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  if (rgb_ == nullptr) return decode_rgbe(rgbe_[index]);
  float t[3];
  std::memcpy(t, rgb_ + 12 * index, sizeof(t));
  return {t[0], t[1], t[2]};
}

// Pictures that were RGBE in their file are so again, a third of the size.
void EnvironmentLight::pack() {
  HugeArray<std::uint32_t> words(static_cast<std::size_t>(width_) *
                                 static_cast<std::size_t>(height_));
  std::atomic<bool> exact = true;
  const auto width = static_cast<std::size_t>(width_);
  parallel_for_dynamic(static_cast<std::size_t>(height_), [&](std::size_t y) {
    if (!exact) return;
    bool row_exact = true;
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      float t[3];
      std::memcpy(t, rgb_ + 12 * i, sizeof(t));
      row_exact &= encode_rgbe(t, words[i]);
    }
    if (!row_exact) exact = false;
  });
  if (!exact) return;
  rgbe_ = std::move(words);
  rgb_ = nullptr;
}

std::optional<EnvironmentView> EnvironmentLight::view() const {
  // Gathers count in 31 bits.
  const std::int64_t words = std::int64_t{3} * width_ * height_;
  if (black_ || is_uniform() || words > std::numeric_limits<std::int32_t>::max()) {
    return std::nullopt;
  }
  EnvironmentView view;
  view.rgb = reinterpret_cast<const float*>(rgb_);
  view.rgbe = rgbe_.data();
  view.width = width_, view.height = height_;
  view.turn = turn_;
  view.colour = colour_;
  view.cdfs = distribution_.cdfs();
  view.guides = distribution_.guides();
  view.columns = static_cast<std::uint32_t>(distribution_.columns());
  view.rows = static_cast<std::uint32_t>(distribution_.rows());
  return view;
}

void EnvironmentLight::build_distribution() {
  const int columns = std::min(width_, kMostColumns), rows = std::min(height_, kMostRows);
  const auto stride = static_cast<std::size_t>(columns);
  std::vector<float> sums(stride * static_cast<std::size_t>(rows));
  struct Row {
    Vec3d sum;
    double weight = 0;
  };
  std::vector<Row> of_rows(static_cast<std::size_t>(rows));
  parallel_for_dynamic(of_rows.size(), [&](std::size_t row) {
    const auto r = static_cast<std::int64_t>(row);
    const auto first = static_cast<int>((r * height_ + rows - 1) / rows);
    const auto end = static_cast<int>(((r + 1) * height_ + rows - 1) / rows);
    for (int y = first; y < end; ++y) {
      const float sine =
          sin_cos_turns(0.5f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height_)).sin;
      Vec3d sum;
      float* cells = sums.data() + row * stride;
      for (int x = 0; x < width_; ++x) {
        const Vec3f value = texel(x, y);
        sum = sum + Vec3d(value);
        cells[std::int64_t{x} * columns / width_] += sine * std::max(luminance(value), 0.0f);
      }
      of_rows[row].sum = of_rows[row].sum + static_cast<double>(sine) * sum;
      of_rows[row].weight += static_cast<double>(sine) * width_;
    }
  });
  Row whole;
  for (const Row& row : of_rows) {
    whole.sum = whole.sum + row.sum;
    whole.weight += row.weight;
  }
  mean_ = colour_ * Vec3f(whole.sum / whole.weight);
  distribution_ =
      PiecewiseConstant2d(blurred(sums, columns, rows), stride, static_cast<std::size_t>(rows));
}

Vec3f EnvironmentLight::lookup(Vec2f uv) const {
  if (!(uv.x >= 0 && uv.y >= 0)) {  // of a direction that is not a number
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    return {kNone, kNone, kNone};
  }
  const float x = uv.x * static_cast<float>(width_) - 0.5f;
  const float y = uv.y * static_cast<float>(height_) - 0.5f;
  const int i = floor_to_int(x), j = floor_to_int(y);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const int x0 = i < 0 ? width_ - 1 : i, x1 = i + 1 < width_ ? i + 1 : 0;
  const int y0 = std::max(j, 0), y1 = std::min(j + 1, height_ - 1);
  return colour_ * ((1 - fy) * ((1 - fx) * texel(x0, y0) + fx * texel(x1, y0)) +
                    fy * ((1 - fx) * texel(x0, y1) + fx * texel(x1, y1)));
}

Vec3f EnvironmentLight::radiance(const Vec3f& direction) const {
  if (black_) return {};
  return is_uniform() ? colour_ : lookup(uv_of(direction, turn_));
}

EnvironmentSample EnvironmentLight::sample(Vec2f u) const {
  if (black_) return {};
  if (is_uniform()) return {sample_uniform_sphere(u.x, u.y), colour_, kUniformPdf};
  const auto found = distribution_.sample(u);
  const Vec3f direction = direction_of(found.point, turn_);
  return {direction, lookup(found.point), per_solid_angle(found.pdf, sine_from(direction.y))};
}

float EnvironmentLight::pdf(const Vec3f& direction) const {
  if (black_) return 0;
  if (is_uniform()) return kUniformPdf;
  return per_solid_angle(distribution_.pdf(uv_of(direction, turn_)), sine_from(direction.y));
}

}  // namespace dapple
