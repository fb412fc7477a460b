// `dapple render` with models, from outside: the size of pictures, and what broken files lead to.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;
using nlohmann::json;

std::pair<int, int> size_of_picture(const TestFolder& folder, const std::string& scene,
                                    const Words& more = {}) {
  Words words = {"dapple", "render", scene, "-o", "out.pfm", "--spp=1", "--depth=1", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  const auto result = folder.run(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  return {report["width"], report["height"]};
}

TEST(RenderModels, AFilmHasTheSizeThatItsFileSays) {
  const TestFolder folder;
  folder.write("film.pbrt",
               "Film \"rgb\" \"integer xresolution\" 40 \"integer yresolution\" 20\n"
               "Camera \"perspective\"\nWorldBegin\nLightSource \"infinite\"\n"
               "Translate 0 0 5 Shape \"sphere\"\n");
  using Size = std::pair<int, int>;
  EXPECT_EQ(size_of_picture(folder, "film.pbrt"), Size(40, 20));
  EXPECT_EQ(size_of_picture(folder, "film.pbrt", {"--width=30"}), Size(30, 15));
  EXPECT_EQ(size_of_picture(folder, "film.pbrt", {"--height=30"}), Size(60, 30));
  EXPECT_EQ(size_of_picture(folder, "film.pbrt", {"--width=30", "--height=30"}), Size(30, 30));
}

TEST(RenderModels, APictureHasTheShapeThatItsCameraIsMeantFor) {
  const TestFolder folder;
  const std::string perspective = R"("type":"perspective","perspective":{"yfov":1,"znear":0.1)";
  folder.write("cameras.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":[)"
                               R"({"name":"wide","camera":0},{"name":"any","camera":1}],)"
                               R"("cameras":[{)" +
                                   perspective + R"(,"aspectRatio":2}},{)" + perspective + "}}]}");
  using Size = std::pair<int, int>;
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40"}), Size(40, 20));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--height=40"}), Size(80, 40));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40", "--camera=wide"}), Size(40, 20));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40", "--height=9"}), Size(40, 9));
  // A camera of any shape, or one that is not the file's: the height has its usual default.
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40", "--camera=1"}), Size(40, 600));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40", "--orbit=0,90,2"}),
            Size(40, 600));
}

}  // namespace
}  // namespace dapple
