// Pictures and bytes for the tests of the image module.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "image/formats.h"

namespace dapple {

inline constexpr const char* kEndings[] = {".ppm", ".png", ".exr", ".pfm", ".hdr"};

// Display-like values: most in [0, 1], some flat areas so that compression has something to do.
inline Image random_image(int width, int height, std::uint32_t seed) {
  std::mt19937 random(seed);
  Image image(width, height);
  Vec3f flat;
  for (Vec3f& pixel : image.pixels) {
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    if (random() % 8 == 0) flat = {uniform(), uniform(), uniform()};
    pixel = random() % 4 == 0 ? Vec3f{uniform(), uniform(), uniform()} : flat;
  }
  return image;
}

// Every kind of float there is, by random bits.
inline Image random_bits_image(int width, int height, std::uint32_t seed) {
  std::mt19937 random(seed);
  Image image(width, height);
  const auto value = [&] { return std::bit_cast<float>(static_cast<std::uint32_t>(random())); };
  for (Vec3f& pixel : image.pixels) pixel = {value(), value(), value()};
  return image;
}

inline Image constant_image(int width, int height, const Vec3f& value) {
  Image image(width, height);
  for (Vec3f& pixel : image.pixels) pixel = value;
  return image;
}

// Equal bit for bit, NaNs too.
inline bool same_bits(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return false;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      if (std::bit_cast<std::uint32_t>(a.pixels[i][c]) !=
          std::bit_cast<std::uint32_t>(b.pixels[i][c])) {
        return false;
      }
    }
  }
  return true;
}

inline std::vector<std::byte> to_bytes(std::string_view text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

inline std::string to_text(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace dapple
