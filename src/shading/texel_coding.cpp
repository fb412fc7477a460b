#include "shading/texel_coding.h"

#include <algorithm>
#include <array>
#include <vector>

#include "image/transfer.h"

namespace dapple {
namespace {

std::uint32_t code(float value, float greatest) {
  return static_cast<std::uint32_t>(std::clamp(value, 0.0f, 1.0f) * greatest + 0.5f);
}

// sRGB codes of linear values, fine enough to be off by one code at most.
class SrgbEncoder {
 public:
  SrgbEncoder() {
    for (std::size_t i = 0; i <= kSteps; ++i) {
      codes_[i] = static_cast<std::uint8_t>(
          encode_integer(static_cast<float>(i) / kSteps, Transfer::srgb, 255));
    }
  }
  std::uint8_t operator()(float value) const { return codes_[code(value, kSteps)]; }

 private:
  static constexpr std::size_t kSteps = 8192;
  std::array<std::uint8_t, kSteps + 1> codes_;
};

void write_8(std::uint8_t* t, std::uint8_t r, std::uint8_t g, std::uint8_t b, float alpha) {
  t[0] = r, t[1] = g, t[2] = b;
  t[3] = static_cast<std::uint8_t>(code(alpha, 255));
}

}  // namespace

const float* srgb8_table() {
  static const std::vector<float> table = decode_table(255, Transfer::srgb);
  return table.data();
}

const float* srgb16_table() {
  static const std::vector<float> table = decode_table(65535, Transfer::srgb);
  return table.data();
}

void write_texel(TexelCoding coding, std::uint8_t* texels, std::size_t index, const Vec4f& value) {
  std::uint8_t* t = texels + coded_bytes(coding) * index;
  if (coding == TexelCoding::rgb32f) {
    const float rgb[3] = {value.x, value.y, value.z};
    std::memcpy(t, rgb, sizeof(rgb));
  } else if (coding == TexelCoding::rgba8_srgb) {
    static const SrgbEncoder encode;
    write_8(t, encode(value.x), encode(value.y), encode(value.z), value.w);
  } else if (coding == TexelCoding::rgba8_linear) {
    const auto byte = [](float v) { return static_cast<std::uint8_t>(code(v, 255)); };
    write_8(t, byte(value.x), byte(value.y), byte(value.z), value.w);
  } else {
    const auto word = [](float v) { return static_cast<std::uint16_t>(code(v, 65535)); };
    const std::uint16_t rgba[4] = {word(value.x), word(value.y), word(value.z), word(value.w)};
    std::memcpy(t, rgba, sizeof(rgba));
  }
}

}  // namespace dapple
