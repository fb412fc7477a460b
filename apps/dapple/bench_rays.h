// Rays to measure an acceleration structure with; the same for every structure and machine.
#pragma once

#include <cstdint>
#include <vector>

#include "accel/accel.h"
#include "render/camera_rays.h"

namespace dapple {

// One ray through each pixel, tile after tile as a renderer would trace them.
[[nodiscard]] Expected<std::vector<Ray>> make_camera_rays(const Camera& camera,
                                                          const RenderSettings& settings);

// From where each of the rays hits, a ray into a random direction around the normal (density
// proportional to the cosine). What hits nothing leaves no ray.
[[nodiscard]] std::vector<Ray> make_bounce_rays(const Accel& accel, const std::vector<Ray>& rays,
                                                std::uint64_t seed);

}  // namespace dapple
