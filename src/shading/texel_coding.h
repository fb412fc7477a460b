// Texels as they lie in memory, and their linear values.
#pragma once

#include <cstdint>
#include <cstring>

#include "math/float4.h"
#include "math/vec4.h"
#include "scene/texture.h"

namespace dapple {

// How a texel's bytes are to be read.
enum class TexelCoding : std::uint32_t {
  rgba8_linear,
  rgba8_srgb,
  rgba16_linear,
  rgba16_srgb,
  rgb32f
};

constexpr TexelCoding coding_of(TexelFormat format, bool colour) {
  if (format == TexelFormat::rgba8) {
    return colour ? TexelCoding::rgba8_srgb : TexelCoding::rgba8_linear;
  }
  if (format == TexelFormat::rgba16) {
    return colour ? TexelCoding::rgba16_srgb : TexelCoding::rgba16_linear;
  }
  return TexelCoding::rgb32f;
}

constexpr std::size_t coded_bytes(TexelCoding coding) {
  return coding <= TexelCoding::rgba8_srgb ? 4 : coding <= TexelCoding::rgba16_srgb ? 8 : 12;
}

// The linear values of all 256 and all 65536 sRGB codes.
const float* srgb8_table();
const float* srgb16_table();

template <TexelCoding coding>
class TexelReader {
 public:
  TexelReader() {
    if constexpr (coding == TexelCoding::rgba8_srgb) table_ = srgb8_table();
    if constexpr (coding == TexelCoding::rgba16_srgb) table_ = srgb16_table();
  }

  // Texel `index` of the array that starts at `texels`; alpha is 1 where none is stored.
  Vec4f operator()(const std::uint8_t* texels, std::size_t index) const {
    if constexpr (coding == TexelCoding::rgb32f) {
      float t[3];
      std::memcpy(t, texels + 12 * index, sizeof(t));
      return {t[0], t[1], t[2], 1.0f};
    } else if constexpr (coded_bytes(coding) == 4) {
      return decode(texels + 4 * index, 1.0f / 255);
    } else {
      std::uint16_t t[4];
      std::memcpy(t, texels + 8 * index, sizeof(t));
      return decode(t, 1.0f / 65535);
    }
  }

  // The same for arithmetic on all four.
  Float4 four(const std::uint8_t* texels, std::size_t index) const {
    if constexpr (coding == TexelCoding::rgba8_linear) {
      return Float4::of_bytes(texels + 4 * index) * Float4::all(1.0f / 255);
    } else {
      const Vec4f t = (*this)(texels, index);
      return Float4::of(t.x, t.y, t.z, t.w);
    }
  }

 private:
  template <class Code>
  Vec4f decode(const Code* t, float scale) const {
    if constexpr (coding == TexelCoding::rgba8_srgb || coding == TexelCoding::rgba16_srgb) {
      return {table_[t[0]], table_[t[1]], table_[t[2]], t[3] * scale};
    } else {
      return {t[0] * scale, t[1] * scale, t[2] * scale, t[3] * scale};
    }
  }

  const float* table_ = nullptr;
};

// Calls use(TexelReader<coding>()).
template <class Use>
auto with_reader(TexelCoding coding, Use&& use) {
  switch (coding) {
    case TexelCoding::rgba8_linear:
      return use(TexelReader<TexelCoding::rgba8_linear>());
    case TexelCoding::rgba8_srgb:
      return use(TexelReader<TexelCoding::rgba8_srgb>());
    case TexelCoding::rgba16_linear:
      return use(TexelReader<TexelCoding::rgba16_linear>());
    case TexelCoding::rgba16_srgb:
      return use(TexelReader<TexelCoding::rgba16_srgb>());
    case TexelCoding::rgb32f:
      break;
  }
  return use(TexelReader<TexelCoding::rgb32f>());
}

// Writes `value` as texel `index`; rgba16_srgb is only read. Integers are rounded, clamped to what
// they can hold.
void write_texel(TexelCoding coding, std::uint8_t* texels, std::size_t index, const Vec4f& value);

}  // namespace dapple
