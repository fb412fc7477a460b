// The size or the shape of pictures that a file means, for those who do not ask for another.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dapple {

inline constexpr int kMaxFilmSide = 1 << 20;  // pixels

struct PictureShape {
  // Width and height that the file asks for.
  std::optional<std::array<int, 2>> resolution = std::nullopt;
  // Width over height that each of the scene's cameras is meant for, 0: any; empty: no file says.
  std::vector<double> camera_aspects = {};

  bool empty() const { return !resolution && camera_aspects.empty(); }
  friend bool operator==(const PictureShape&, const PictureShape&) = default;
};

// Why a scene with that many cameras cannot have it; empty when it can.
[[nodiscard]] std::string reason_against(const PictureShape& shape, std::size_t camera_count);

}  // namespace dapple
