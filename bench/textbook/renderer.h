// The loop over pixels and samples of a textbook ray tracer; rows are shared out among threads.
#pragma once

#include <cstdint>

#include "image/image.h"
#include "render/settings.h"
#include "scene/camera.h"
#include "textbook/world.h"

namespace dapple::textbook {

struct Picture {
  Image image;  // linear radiance
  std::uint64_t ray_count = 0;
};

[[nodiscard]] Picture render(const World& world, const Camera& camera,
                             const RenderSettings& settings);

}  // namespace dapple::textbook
