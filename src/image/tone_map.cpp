#include "image/tone_map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "math/functions.h"
#include "math/transform.h"

namespace dapple {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"neutral", "none", "agx", "aces"};

Vec3f clamp_colour(const Vec3f& c, float low, float high) {
  return {std::clamp(c.x, low, high), std::clamp(c.y, low, high), std::clamp(c.z, low, high)};
}

// Also where a value is not a number.
Vec3f without_negatives(const Vec3f& c) {
  return {c.x > 0 ? c.x : 0, c.y > 0 ? c.y : 0, c.z > 0 ? c.z : 0};
}

// [Khronos24]: the lowest channel loses what a surface reflects without colour, and what is above
// the shoulder is compressed and then desaturated.
Vec3f neutral(Vec3f c) {
  constexpr float kStart = 0.8f - 0.04f, kDesaturation = 0.15f;
  const float lowest = std::min({c.x, c.y, c.z});
  const float offset = lowest < 0.08f ? lowest - 6.25f * lowest * lowest : 0.04f;
  c = c - Vec3f(offset, offset, offset);
  const float peak = std::max({c.x, c.y, c.z});
  if (peak < kStart) return c;
  constexpr float kRoom = 1.0f - kStart;
  const float new_peak = 1.0f - kRoom * kRoom / (peak + kRoom - kStart);
  c = (new_peak / peak) * c;
  const float grey = 1.0f - 1.0f / (kDesaturation * (peak - new_peak) + 1.0f);
  return (1.0f - grey) * c + grey * Vec3f(new_peak, new_peak, new_peak);
}

constexpr Transformf linear_map(const float (&m)[3][3]) {
  Transformf map;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) map.rows[i][j] = m[i][j];
  }
  return map;
}

// The fit that Hill made of the reference rendering and sRGB output transforms, with the exposure
// that makes middle grey stay where it is, as three.js has it.
Vec3f aces(const Vec3f& colour) {
  constexpr Transformf kIn = linear_map({{0.59719f, 0.35458f, 0.04823f},
                                         {0.07600f, 0.90834f, 0.01566f},
                                         {0.02840f, 0.13383f, 0.83777f}});
  constexpr Transformf kOut = linear_map({{1.60475f, -0.53108f, -0.07367f},
                                          {-0.10208f, 1.10813f, -0.00605f},
                                          {-0.00327f, -0.07276f, 1.07602f}});
  const auto fit = [](float v) {
    return (v * (v + 0.0245786f) - 0.000090537f) / (v * (0.983729f * v + 0.4329510f) + 0.238081f);
  };
  const Vec3f v = kIn.vector((1.0f / 0.6f) * colour);
  return kOut.vector(Vec3f(fit(v.x), fit(v.y), fit(v.z)));
}

// The polynomial that Wrensch fitted to AgX's contrast curve.
float agx_contrast(float x) {
  const float x2 = x * x, x4 = x2 * x2;
  return 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 +
         0.1191f * x - 0.00232f;
}

float agx_channel(float value) {
  constexpr double kLowest = -12.47393, kHighest = 4.026069;  // stops
  const double stops = binary_log(std::max(static_cast<double>(value), 1e-10));
  const double x = (std::clamp(stops, kLowest, kHighest) - kLowest) / (kHighest - kLowest);
  return agx_contrast(static_cast<float>(x));
}

Vec3f agx(const Vec3f& colour) {
  constexpr Transformf kInset =
      linear_map({{0.842479062253094f, 0.0784335999999992f, 0.0792237451477643f},
                  {0.0423282422610123f, 0.878468636469772f, 0.0791661274605434f},
                  {0.0423756549057051f, 0.0784336f, 0.879142973793104f}});
  constexpr Transformf kOutset =
      linear_map({{1.19687900512017f, -0.0980208811401368f, -0.0990297440797205f},
                  {-0.0528968517574562f, 1.15190312990417f, -0.0989611768448433f},
                  {-0.0529716355144438f, -0.0980434501171241f, 1.15107367264116f}});
  const Vec3f v = kInset.vector(colour);
  const Vec3f display = kOutset.vector(Vec3f(agx_channel(v.x), agx_channel(v.y), agx_channel(v.z)));
  const auto to_linear = [](float x) { return static_cast<float>(power(x, 2.2)); };
  const Vec3f d = without_negatives(display);
  return {to_linear(d.x), to_linear(d.y), to_linear(d.z)};
}

}  // namespace

Expected<ToneMap> parse_tone_map(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<ToneMap>(i);
  }
  return fail(Errc::usage, std::string(name),
              fmt::format("unknown tone map; there are {}", fmt::join(kNames, ", ")));
}

Vec3f tone_map(ToneMap curve, const Vec3f& colour) {
  constexpr float kBrightest = 1e6f;  // far beyond where every curve is flat, so nothing overflows
  Vec3f c = clamp_colour(without_negatives(colour), 0.0f, kBrightest);
  if (curve == ToneMap::neutral) c = neutral(c);
  if (curve == ToneMap::agx) c = agx(c);
  if (curve == ToneMap::aces) c = aces(c);
  return clamp_colour(c, 0.0f, 1.0f);
}

float automatic_exposure(const Image& image) {
  constexpr double kMiddleGrey = 0.18, kMostStops = 24;
  double stops = 0;
  std::size_t count = 0;
  for (const Vec3f& p : image.pixels) {
    const double luminance = 0.2126 * double{p.x} + 0.7152 * double{p.y} + 0.0722 * double{p.z};
    if (!(luminance > 1e-12) || !(luminance < 1e12)) continue;
    stops += binary_log(luminance);
    ++count;
  }
  if (count == 0) return 0;
  const double mean = stops / static_cast<double>(count);
  return static_cast<float>(std::clamp(binary_log(kMiddleGrey) - mean, -kMostStops, kMostStops));
}

void apply_tone_map(Image& image, ToneMap curve, float exposure) {
  const auto scale = static_cast<float>(binary_exp(exposure));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    Vec3f& pixel = image.pixels[i];
    const float alpha = image.alpha.empty() ? 1.0f : image.alpha[i];
    // The curve is for colours, not for what they cover of a pixel.
    pixel = alpha > 0.0f ? alpha * tone_map(curve, (scale / alpha) * pixel) : Vec3f();
  }
}

}  // namespace dapple
