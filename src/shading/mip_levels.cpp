#include "shading/mip_levels.h"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.h"

namespace dapple {
namespace {

// The texels that one of the smaller level covers along one axis: up to three, their weights sum
// to 1.
struct Taps {
  std::int32_t first = 0;
  std::int32_t count = 0;
  float weights[4] = {};
};

std::vector<Taps> taps_of_axis(std::int32_t larger, std::int32_t smaller) {
  std::vector<Taps> taps(static_cast<std::size_t>(smaller));
  const double step = static_cast<double>(larger) / smaller;
  for (std::int32_t i = 0; i < smaller; ++i) {
    const double begin = i * step, end = std::min((i + 1) * step, double(larger));
    Taps& t = taps[static_cast<std::size_t>(i)];
    t.first = static_cast<std::int32_t>(begin);
    for (std::int32_t k = t.first; k < larger && k < end - 1e-9 && t.count < 4; ++k) {
      const double covered = std::min<double>(end, k + 1) - std::max<double>(begin, k);
      t.weights[t.count++] = static_cast<float>(covered / step);
    }
  }
  return taps;
}

TexelCoding smaller_coding(TexelCoding coding) {
  return coding == TexelCoding::rgba16_srgb ? TexelCoding::rgba16_linear : coding;
}

template <class Reader>
Vec4f covered(const Reader& read, const MipLevel& level, const Taps& x, const Taps& y) {
  Vec4f sum;
  for (std::int32_t j = 0; j < y.count; ++j) {
    const std::size_t row =
        static_cast<std::size_t>(y.first + j) * static_cast<std::size_t>(level.width);
    for (std::int32_t i = 0; i < x.count; ++i) {
      sum = sum + (x.weights[i] * y.weights[j]) *
                      read(level.texels, row + static_cast<std::size_t>(x.first + i));
    }
  }
  return sum;
}

}  // namespace

OwnedMipLevel next_mip_level(const MipLevel& larger) {
  OwnedMipLevel result;
  MipLevel& level = result.level;
  level = {nullptr, smaller_coding(larger.coding), std::max(larger.width / 2, 1),
           std::max(larger.height / 2, 1)};
  const auto width = static_cast<std::size_t>(level.width);
  const auto height = static_cast<std::size_t>(level.height);
  result.storage.resize(width * height * coded_bytes(level.coding));
  level.texels = result.storage.data();
  const std::vector<Taps> columns = taps_of_axis(larger.width, level.width);
  const std::vector<Taps> rows = taps_of_axis(larger.height, level.height);
  const auto make_rows = [&](std::size_t begin, std::size_t end) {
    with_reader(larger.coding, [&](const auto& read) {
      for (std::size_t y = begin; y < end; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
          write_texel(level.coding, result.storage.data(), y * width + x,
                      covered(read, larger, columns[x], rows[y]));
        }
      }
    });
  };
  // Below this many texels a loop over threads costs more than it saves.
  constexpr std::size_t kTexelsAtOnce = 1u << 14;
  const std::size_t rows_at_once = std::max<std::size_t>(kTexelsAtOnce / width, 1);
  const std::size_t blocks = (height + rows_at_once - 1) / rows_at_once;
  if (blocks == 1) {
    make_rows(0, height);
  } else {
    parallel_for_dynamic(blocks, [&](std::size_t block) {
      make_rows(block * rows_at_once, std::min((block + 1) * rows_at_once, height));
    });
  }
  return result;
}

}  // namespace dapple
