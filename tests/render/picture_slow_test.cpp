// The same pictures with sixteen times the samples: errors a quarter of the size show.
#include <gtest/gtest.h>

#include "tests/render/picture_cases.h"

namespace dapple::test {
namespace {

class LongPicture : public ::testing::TestWithParam<std::size_t> {};

TEST_P(LongPicture, AgreesWithTheReference) { check_picture(GetParam(), 16); }

INSTANTIATE_TEST_SUITE_P(Scenes, LongPicture, ::testing::Range(std::size_t{0}, kPictureCaseCount));

}  // namespace
}  // namespace dapple::test
