// Images that surfaces and environments are painted with, decoded.
#pragma once

#include <cstdint>

namespace dapple {

enum class ImageId : std::uint32_t {};
enum class TextureId : std::uint32_t {};
inline constexpr ImageId kNoImage{0xffffffffu};
inline constexpr TextureId kNoTexture{0xffffffffu};

// How one texel is stored; rows follow each other from the top without gaps.
enum class TexelFormat : std::uint32_t {
  rgba8,   // four bytes; whether they are sRGB or linear is the use's to say (layered_material.h)
  rgba16,  // four 16-bit integers, little-endian, otherwise the same
  rgb32f,  // three floats, linear
};

constexpr std::uint64_t texel_bytes(TexelFormat format) {
  return format == TexelFormat::rgba8 ? 4 : format == TexelFormat::rgba16 ? 8 : 12;
}

// Where an image lies in the scene's array of texel bytes.
struct TextureImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  TexelFormat format = TexelFormat::rgba8;
  std::uint32_t reserved = 0;
  std::uint64_t offset = 0;  // bytes, a multiple of 16
  friend bool operator==(const TextureImage&, const TextureImage&) = default;

  constexpr std::uint64_t bytes() const {
    return std::uint64_t{width} * height * texel_bytes(format);
  }
};

enum class Wrap : std::uint32_t { repeat, mirrored_repeat, clamp_to_edge };
enum class Filter : std::uint32_t { linear, nearest };

struct Texture {
  ImageId image = kNoImage;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  Filter filter = Filter::linear;  // linear: bilinear, and between mip levels when minified
  friend bool operator==(const Texture&, const Texture&) = default;
};

}  // namespace dapple
