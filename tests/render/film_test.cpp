// The film: exact sums in any order, clamping, and samples that are not finite.
#include "render/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render/settings.h"

namespace dapple::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

TEST(Film, SumsDoNotDependOnTheOrder) {
  std::mt19937_64 random(1);
  std::vector<Vec3f> samples(5000);
  for (Vec3f& s : samples) {
    const auto value = [&] { return std::ldexp(float(random() >> 40), int(random() % 30) - 40); };
    s = {value(), value(), value()};
  }
  const Tile tile{0, 0, 1, 1};
  TileSums forwards(tile);
  for (const Vec3f& s : samples) forwards.add(0, s);
  for (int repeat = 0; repeat < 10; ++repeat) {
    std::shuffle(samples.begin(), samples.end(), random);
    TileSums shuffled(tile);
    for (const Vec3f& s : samples) shuffled.add(0, s);
    EXPECT_EQ(shuffled.sums()[0], forwards.sums()[0]);
  }
}

TEST(Film, TheMeanIsExactToAStep) {
  TileSums sums(Tile{0, 0, 1, 1});
  double exact = 0;
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) {
    const float value = float(random() >> 40) * 0x1p-24f;
    sums.add(0, {value, 1, 0.25f});
    exact += value;
  }
  Film film(1, 1);
  film.merge(sums);
  const Image image = film.to_image(1000);
  EXPECT_EQ(image.at(0, 0).x, static_cast<float>(exact / 1000));
  EXPECT_EQ(image.at(0, 0).y, 1.0f);
  EXPECT_EQ(image.at(0, 0).z, 0.25f);
}

TEST(Film, SamplesThatAreNotFiniteAreCountedAndLeftOut) {
  TileSums sums(Tile{0, 0, 2, 1});
  sums.add(0, {1, 2, 3});
  for (const Vec3f& bad : {Vec3f(kNan, 1, 1), Vec3f(1, kInfinite, 1), Vec3f(1, 1, -kInfinite)}) {
    sums.add(0, bad);
  }
  EXPECT_EQ(sums.dropped(), 3u);
  EXPECT_EQ(sums.sums()[1], PixelSum{});
  Film film(2, 1);
  film.merge(sums);
  film.merge(sums);
  EXPECT_EQ(film.dropped(), 6u);
  EXPECT_EQ(film.to_image(2).at(0, 0), Vec3f(1, 2, 3));
}

TEST(Film, SamplesAreCutToTheRange) {
  TileSums sums(Tile{0, 0, 1, 1});
  sums.add(0, {-1, 1e30f, kFilmClamp});
  Film film(1, 1);
  film.merge(sums);
  EXPECT_EQ(film.to_image(1).at(0, 0), Vec3f(0, kFilmClamp, kFilmClamp));
  EXPECT_EQ(film.cut_count(), 1u);
}

TEST(Film, SamplesThatAreCutAreCounted) {
  TileSums sums(Tile{0, 0, 1, 1});
  sums.add(0, {kFilmClamp, kFilmClamp, kFilmClamp});
  EXPECT_EQ(sums.cut_count(), 0u);
  sums.add(0, {0, 0, 2 * kFilmClamp});
  sums.add(0, {1e30f, 1e30f, 1e30f});
  sums.add(0, {kInfinite, 0, 0});
  EXPECT_EQ(sums.cut_count(), 2u);
  Film film(1, 1);
  film.merge(sums);
  film.merge(sums);
  EXPECT_EQ(film.cut_count(), 4u);
}

// The brightest picture of the most samples stays within 64 bits.
TEST(Film, TheLargestSumFits) {
  const long double most = static_cast<long double>(kFilmClamp) * kFilmStepsPerUnit *
                           static_cast<long double>(kMaxSamplesPerPixel);
  EXPECT_LE(most, static_cast<long double>(std::numeric_limits<std::int64_t>::max()));
}

TEST(Film, TilesGoWhereTheyBelong) {
  constexpr int kWidth = 7, kHeight = 5;
  Film film(kWidth, kHeight);
  for (const Tile& tile : {Tile{3, 0, 7, 2}, Tile{0, 0, 3, 5}, Tile{3, 2, 7, 5}}) {
    TileSums sums(tile);
    std::size_t index = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) sums.add(index++, {float(x), float(y), 1});
    }
    film.merge(sums);
  }
  const Image image = film.to_image(1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) EXPECT_EQ(image.at(x, y), Vec3f(float(x), float(y), 1));
  }
}

}  // namespace
}  // namespace dapple::test
