// A whole rendering: the picture cut into units of work, done in parallel.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

#include "image/image.h"
#include "parallel/thread_times.h"
#include "render/prepared_scene.h"
#include "render/settings.h"

namespace dapple {

struct RenderControl {
  // Called after each unit with the number done and the number in all; from any thread, but never
  // from two at once.
  std::function<void(std::size_t done, std::size_t total)> progress;
  // Set to stop: units in hand are finished, no new one is begun.
  const std::atomic<bool>* cancel = nullptr;
  // Where to write how long each thread was at work, if anybody wants to know.
  ThreadTimes* thread_times = nullptr;
};

struct RenderResult {
  Image image;                        // linear radiance
  std::uint64_t dropped_samples = 0;  // samples that were not finite and count as black
  std::uint64_t cut_samples = 0;      // samples brighter than the film holds, kFilmClamp
  // Mean over the picture and its channels of the radiance that the clamp of indirect light took
  // away.
  double clamped_radiance = 0;
};

// The same picture, to the bit, on any number of threads and with any acceleration structure.
[[nodiscard]] Expected<RenderResult> render(const PreparedScene& scene,
                                            const RenderSettings& settings,
                                            const RenderControl& control = {});

}  // namespace dapple
