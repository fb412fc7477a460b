#include "scene/picture_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dapple {
namespace {

bool is_side(int side) { return side > 0 && side <= kMaxFilmSide; }

bool is_aspect(double aspect) { return aspect >= 0 && std::isfinite(aspect); }

}  // namespace

std::string reason_against(const PictureShape& shape, std::size_t camera_count) {
  const auto& size = shape.resolution;
  if (size && !(is_side((*size)[0]) && is_side((*size)[1]))) {
    return fmt::format("a film with a side not from 1 to {}", kMaxFilmSide);
  }
  const auto& aspects = shape.camera_aspects;
  if (!aspects.empty() && aspects.size() != camera_count) {
    return "the shapes of pictures and the cameras differ in number";
  }
  if (!std::all_of(aspects.begin(), aspects.end(), is_aspect)) {
    return "the shape of a camera's picture is negative or not finite";
  }
  return "";
}

}  // namespace dapple
