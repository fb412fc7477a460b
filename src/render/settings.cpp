#include "render/settings.h"

#include <fmt/format.h>

namespace dapple {

Status validate(const RenderSettings& s) {
  const auto check = [](const char* name, std::int64_t value, std::int64_t high) -> Status {
    if (value >= 1 && value <= high) return {};
    return fail(Errc::usage, name, fmt::format("{} is not from 1 to {}", value, high));
  };
  if (auto status = check("width", s.width, kMaxImageSide); !status) return status;
  if (auto status = check("height", s.height, kMaxImageSide); !status) return status;
  if (auto status = check("samples", s.samples_per_pixel, kMaxSamplesPerPixel); !status) {
    return status;
  }
  return check("pixels", std::int64_t{s.width} * s.height, kMaxPixelCount);
}

}  // namespace dapple
