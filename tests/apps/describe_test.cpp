// Scenes in words: the exact text, and JSON that loses nothing.
#include "scene/describe.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "scene/named_scenes.h"
#include "scene/validate.h"
#include "tests/apps/run_program.h"

namespace dapple {
namespace {

constexpr const char* kNiceObjects =
    "yz_rectangle\n"
    "    y0=-5.000000\n"
    "    y1=0.000000\n"
    "    z0=-5.000000\n"
    "    z1=5.000000\n"
    "    k=-4.000000\n"
    "    material=metal(albedo=(1.000000,0.000000,0.000000), fuzz=0.900000)\n"
    "yz_rectangle\n"
    "    y0=-5.000000\n"
    "    y1=0.000000\n"
    "    z0=-5.000000\n"
    "    z1=5.000000\n"
    "    k=4.000000\n"
    "    material=metal(albedo=(0.000000,1.000000,0.000000), fuzz=0.900000)\n"
    "sphere\n"
    "    centre=(4.000000,0.000000,-6.000000)\n"
    "    material=lambertian(albedo=(0.800000,0.800000,0.800000))\n"
    "xy_rectangle\n"
    "    x0=-4.000000\n"
    "    x1=4.000000\n"
    "    y0=-5.000000\n"
    "    y1=0.000000\n"
    "    k=-5.000000\n"
    "    material=metal(albedo=(0.000000,0.000000,1.000000), fuzz=0.900000)\n";

std::string text_of(const Scene& scene, DescribeDetail detail) {
  std::string text;
  const Status status = describe(scene, detail, [&](std::string_view piece) -> Status {
    text += piece;
    return {};
  });
  EXPECT_TRUE(status);
  return text;
}

nlohmann::json json_of(const Scene& scene) {
  std::string text;
  EXPECT_TRUE(describe_json(scene, [&](std::string_view piece) -> Status {
    text += piece;
    return {};
  }));
  return nlohmann::json::parse(text);
}

TEST(DescribeScene, PrintsNiceExactly) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "f", "nice"}).exit_code, 0);
  const auto result = folder.run({"describe_scene", "f"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, kNiceObjects);
  EXPECT_EQ(result.err, "");
}

TEST(DescribeScene, PrintsNothingForAnEmptyScene) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "f", "empty"}).exit_code, 0);
  const auto result = folder.run({"describe_scene", "f"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "");
}

TEST(DescribeScene, ReadsAFileEvenIfItHasASceneName) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "irreg", "nice"}).exit_code, 0);
  EXPECT_EQ(folder.run({"describe_scene", "irreg"}).out, kNiceObjects);
}

TEST(DescribeScene, OptionsStandAnywhere) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "f", "nice"}).exit_code, 0);
  const std::string full = folder.run({"describe_scene", "--full", "f"}).out;
  EXPECT_EQ(full, text_of(*make_named_scene("nice"), DescribeDetail::full));
  EXPECT_EQ(full, folder.run({"describe_scene", "f", "--full"}).out);
  EXPECT_EQ(full, folder.run({"describe_scene", "--full", "--", "f"}).out);
  EXPECT_EQ(full, folder.run({"dapple", "info", "nice"}).out);
  const std::string json = folder.run({"describe_scene", "f", "--json"}).out;
  EXPECT_EQ(json, folder.run({"dapple", "info", "--json", "nice"}).out);
  EXPECT_EQ(nlohmann::json::parse(json)["counts"]["objects"], 4);
}

TEST(DescribeScene, FullAddsCameraCountsAndRadii) {
  const std::string full = text_of(*make_named_scene("nice"), DescribeDetail::full);
  EXPECT_TRUE(
      full.starts_with("camera\n"
                       "    lookfrom=(0.000000,3.000000,3.000000)\n"
                       "    lookat=(0.000000,0.000000,0.000000)\n"
                       "    up=(0.000000,1.000000,0.000000)\n"
                       "    vertical_fov=75.000000\n"
                       "    aperture=0.010000\n"
                       "    focus_distance=10.000000\n"
                       "counts\n"
                       "    objects=4\n"
                       "    sphere=1\n"
                       "    xy_rectangle=1\n"
                       "    xz_rectangle=0\n"
                       "    yz_rectangle=2\n"
                       "    materials=4\n"))
      << full;
  EXPECT_NE(full.find("    centre=(4.000000,0.000000,-6.000000)\n    radius=2.000000\n"),
            std::string::npos);
}

TEST(DescribeScene, PrintsTheOtherShapesAndMaterials) {
  Scene scene;
  const MaterialId glass = scene.add_material(Dielectric{1.5});
  scene.add_rectangle(ShapeKind::xz_rectangle, {1, 2, 3, 4, 5}, glass);
  EXPECT_EQ(text_of(scene, DescribeDetail::objects),
            "xz_rectangle\n"
            "    x0=1.000000\n"
            "    x1=2.000000\n"
            "    z0=3.000000\n"
            "    z1=4.000000\n"
            "    k=5.000000\n"
            "    material=dielectric(ref_idx=1.500000)\n");
}

// Two triangles in the world around a sphere, and two instances of a third.
Scene scene_with_meshes() {
  Scene scene;
  scene.layered_materials.resize(1);
  scene.layered_materials[0].metallic = 1;
  scene.layered_materials[0].clearcoat = 0.5f;
  scene.layered_materials[0].map(MapUse::normal).texture = TextureId{0};
  const MaterialId paint = scene.add_material(Layered{0});
  const MaterialId chalk = scene.add_material(Lambertian{{0.5, 0.5, 0.5}});
  scene.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  scene.add_triangle({{0, 1, 2}}, chalk);
  scene.add_triangle({{0, 1, 3}}, paint);
  scene.add_sphere({{1, 2, 3}, 4}, chalk);
  scene.add_cylinder({{0, 0, 0}, {0, 1, 0}, 0.5}, chalk);
  scene.add_prototype(std::vector<Triangle>{{{1, 2, 3}}}, std::vector{paint});
  scene.add_instance({});
  scene.add_instance({Transformf{{{1, 0, 0, 5}, {0, 1, 0, 6}, {0, 0, 1, 7}}}, 0});
  scene.images = {{1, 1, TexelFormat::rgba8, 0, 0}};
  scene.texels.resize(4);
  scene.textures.resize(1);
  scene.textures[0].image = ImageId{0};
  scene.lights.resize(1);
  scene.environment.kind = EnvironmentKind::studio;
  scene.cameras.resize(1);
  scene.cameras[0].name = {'a', '"', 'b'};
  EXPECT_TRUE(validate(scene));
  return scene;
}

constexpr const char* kPaint =
    "    material=layered(base_colour=(1.000000,1.000000,1.000000), metallic=1.000000, "
    "roughness=1.000000, clearcoat=0.500000, normal_map=0)\n";
constexpr const char* kChalk = "    material=lambertian(albedo=(0.500000,0.500000,0.500000))\n";

TEST(DescribeScene, TrianglesThatFollowEachOtherAreOneMesh) {
  const std::string expected =
      std::string(
          "mesh\n"
          "    triangles=2\n"
          "    lo=(0.000000,0.000000,0.000000)\n"
          "    hi=(1.000000,2.000000,3.000000)\n") +
      kChalk + kPaint +
      "sphere\n"
      "    centre=(1.000000,2.000000,3.000000)\n" +
      kChalk +
      "cylinder\n"
      "    begin=(0.000000,0.000000,0.000000)\n"
      "    end=(0.000000,1.000000,0.000000)\n"
      "    radius=0.500000\n" +
      kChalk +
      "instance\n"
      "    prototype=0\n"
      "    triangles=1\n"
      "    to_world=((1.000000,0.000000,0.000000,0.000000),(0.000000,1.000000,0.000000,0.000000),"
      "(0.000000,0.000000,1.000000,0.000000))\n"
      "instance\n"
      "    prototype=0\n"
      "    triangles=1\n"
      "    to_world=((1.000000,0.000000,0.000000,5.000000),(0.000000,1.000000,0.000000,6.000000),"
      "(0.000000,0.000000,1.000000,7.000000))\n";
  EXPECT_EQ(text_of(scene_with_meshes(), DescribeDetail::objects), expected);
}

TEST(DescribeScene, FullSaysWhatElseIsThere) {
  const std::string full = text_of(scene_with_meshes(), DescribeDetail::full);
  for (const char* line :
       {"    objects=6\n", "    triangle=3\n", "    vertices=4\n", "    prototypes=1\n",
        "    bytes_per_triangle=32.0\n", "    bytes_per_instance=52.0\n",
        "prototype 0\n    triangles=1\n", "texture 0\n    image=0\n    wrap=(repeat,repeat)\n",
        "image 0\n    size=1x1\n    format=rgba8\n    bytes=4\n", "light\n    kind=point\n",
        "environment\n    kind=studio\n", "camera a\"b\n    lookfrom="}) {
    EXPECT_NE(full.find(line), std::string::npos) << line << "not in\n" << full;
  }
}

TEST(DescribeJson, SaysEverythingButVertices) {
  const nlohmann::json json = json_of(scene_with_meshes());
  EXPECT_EQ(json["counts"]["triangle"], 3);
  EXPECT_EQ(json["counts"]["objects"], 6);
  EXPECT_EQ(json["counts"]["bytes_per_instance"], 52);
  EXPECT_EQ(json["objects"].size(), 5u);
  EXPECT_EQ(json["objects"][0]["type"], "mesh");
  EXPECT_EQ(json["objects"][0]["triangles"], 2);
  EXPECT_EQ(json["objects"][0]["materials"], nlohmann::json({1, 0}));
  EXPECT_EQ(json["objects"][0]["hi"], nlohmann::json({1, 2, 3}));
  EXPECT_EQ(json["objects"][4]["to_world"][1], nlohmann::json({0, 1, 0, 6}));
  EXPECT_EQ(json["prototypes"][0]["first_triangle"], 2);
  EXPECT_EQ(json["materials"][0], nlohmann::json({{"type", "layered"}, {"index", 0}}));
  const auto& paint = json["layered_materials"][0];
  EXPECT_EQ(paint["clearcoat"], 0.5);
  EXPECT_EQ(paint["attenuation_distance"], nullptr);
  EXPECT_EQ(paint["maps"]["normal"]["texture"], 0);
  EXPECT_EQ(paint["maps"].size(), 1u);
  EXPECT_EQ(json["textures"][0]["wrap_u"], "repeat");
  EXPECT_EQ(json["images"][0]["bytes"], 4);
  EXPECT_EQ(json["lights"][0]["kind"], "point");
  EXPECT_EQ(json["environment"]["kind"], "studio");
  EXPECT_EQ(json["cameras"][0]["name"], "a\"b");
  EXPECT_EQ(json["cameras"][0]["camera"]["orthographic_height"], 0);
}

// Doubles with nothing round about them, negative zero and the smallest ones included.
class RandomNumbers {
 public:
  double operator()() {
    switch (generator_() % 8) {
      case 0:
        return -0.0;
      case 1:
        return 5e-324;
      case 2:
        return static_cast<double>(static_cast<int>(generator_() % 100)) - 50;
      default:
        break;
    }
    while (true) {
      const double value = std::bit_cast<double>(generator_());
      if (std::fabs(value) <= kMaxCoordinate) return value;
    }
  }
  std::uint64_t below(std::uint64_t n) { return generator_() % n; }
  Vec3d vector() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937_64 generator_{1};
};

Scene random_scene(RandomNumbers& random) {
  Scene scene;
  scene.camera.look_from = random.vector();
  scene.camera.look_at = random.vector();
  scene.add_material(Lambertian{random.vector()});
  scene.add_material(Metal{random.vector(), random()});
  scene.add_material(Dielectric{random()});
  for (std::uint64_t i = random.below(20); i > 0; --i) {
    const auto material = static_cast<MaterialId>(random.below(3));
    const auto kind = static_cast<ShapeKind>(random.below(1 + kRectangleKindCount));
    if (kind == ShapeKind::sphere) {
      scene.add_sphere({random.vector(), random()}, material);
    } else {
      scene.add_rectangle(kind, {random(), random(), random(), random(), random()}, material);
    }
  }
  return scene;
}

Vec3d vector_from(const nlohmann::json& json) { return {json[0], json[1], json[2]}; }

Material material_from(const nlohmann::json& json) {
  if (json["type"] == "lambertian") return Lambertian{vector_from(json["albedo"])};
  if (json["type"] == "metal") return Metal{vector_from(json["albedo"]), json["fuzz"]};
  return Dielectric{json["ref_idx"]};
}

void add_object(const nlohmann::json& json, Scene& scene) {
  const auto material = static_cast<MaterialId>(json["material"].get<std::uint32_t>());
  const std::string type = json["type"];
  if (type == "sphere") {
    scene.add_sphere({vector_from(json["centre"]), json["radius"]}, material);
    return;
  }
  const auto number = [&](char axis, char end) { return json[std::string{axis, end}]; };
  for (std::size_t i = 0; i < kRectangleKindCount; ++i) {
    if (shape_name(rectangle_kind(i)) != type) continue;
    scene.add_rectangle(rectangle_kind(i),
                        {number(type[0], '0'), number(type[0], '1'), number(type[1], '0'),
                         number(type[1], '1'), json["k"]},
                        material);
  }
}

Scene scene_from(const nlohmann::json& json) {
  Scene scene;
  const auto& camera = json["camera"];
  scene.camera = {vector_from(camera["lookfrom"]),
                  vector_from(camera["lookat"]),
                  vector_from(camera["up"]),
                  camera["vertical_fov"],
                  camera["aperture"],
                  camera["focus_distance"]};
  for (const auto& material : json["materials"]) scene.add_material(material_from(material));
  for (const auto& object : json["objects"]) add_object(object, scene);
  return scene;
}

// The text of doubles as hexadecimal floats, so that -0 and 0 differ.
std::string exact_text(const Scene& scene) {
  std::string text;
  for (const Sphere& s : scene.spheres) {
    text += fmt::format("{:a} {:a} {:a} {:a};", s.centre.x, s.centre.y, s.centre.z, s.radius);
  }
  for (const auto& kind : scene.rectangles) {
    for (const Rectangle& r : kind) {
      text += fmt::format("{:a} {:a} {:a} {:a} {:a};", r.u0, r.u1, r.v0, r.v1, r.k);
    }
  }
  return text;
}

TEST(DescribeJson, ReadsBackBitForBit) {
  RandomNumbers random;
  for (int i = 0; i < 300; ++i) {
    const Scene scene = random_scene(random);
    const Scene back = scene_from(json_of(scene));
    ASSERT_EQ(back, scene);
    ASSERT_EQ(exact_text(back), exact_text(scene));
  }
}

TEST(DescribeJson, CountsAgreeWithTheScene) {
  RandomNumbers random;
  for (int i = 0; i < 50; ++i) {
    const Scene scene = random_scene(random);
    const SceneView view(scene);
    const nlohmann::json counts = json_of(scene)["counts"];
    EXPECT_EQ(counts["objects"], view.object_count());
    EXPECT_EQ(counts["materials"], scene.materials.size());
    for (std::size_t k = 0; k < kShapeKindCount; ++k) {
      const auto kind = static_cast<ShapeKind>(k);
      EXPECT_EQ(counts[std::string(shape_name(kind))], view.count(kind));
    }
  }
}

// A scene of any size goes out in pieces of bounded size, and stops when nobody takes them.
TEST(DescribeScene, StreamsInBoundedPieces) {
  const Scene scene = *make_named_scene("spheres:20000");
  for (const bool as_json : {false, true}) {
    std::size_t largest = 0, total = 0;
    const TextSink measure = [&](std::string_view piece) -> Status {
      largest = std::max(largest, piece.size());
      total += piece.size();
      return {};
    };
    ASSERT_TRUE(as_json ? describe_json(scene, measure)
                        : describe(scene, DescribeDetail::full, measure));
    EXPECT_GT(total, std::size_t{1} << 20);
    EXPECT_LT(largest, std::size_t{80} << 10);

    int calls = 0;
    const TextSink refuse = [&](std::string_view) -> Status {
      ++calls;
      return fail(Errc::io, "sink", "full");
    };
    const Status status =
        as_json ? describe_json(scene, refuse) : describe(scene, DescribeDetail::objects, refuse);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().message, "full");
    EXPECT_EQ(calls, 1);
  }
}

}  // namespace
}  // namespace dapple
