// The library's pictures in the form in which statistics can judge them.
#pragma once

#include <gtest/gtest.h>

#include "render/settings.h"
#include "tests/reference/reference_tracer.h"
#include "tests/scenes/picture_scenes.h"
#include "tests/statistics/chi_squared.h"
#include "tests/statistics/picture_statistics.h"

namespace dapple::test {

// Mean and variance over the samples of a rendering by the library, through the fast structure.
[[nodiscard]] PictureStatistics rendered_picture(const Scene& scene,
                                                 const RenderSettings& settings);

// The library's and the reference's picture of a scene, of one size and number of samples.
[[nodiscard]] PictureAgreement agreement_with_reference(const Scene& scene,
                                                        const ReferenceSettings& size);

// Success when the two pictures' difference is noise at level kSignificance / `tests`.
[[nodiscard]] ::testing::AssertionResult agree(const PictureAgreement& agreement,
                                               std::size_t tests);

}  // namespace dapple::test
