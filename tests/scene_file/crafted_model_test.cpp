// Files of models whose checksums are all right and whose contents are not: each check on its own.
// What a file may not say a scene may not say either, so each is tried both ways.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "scene/layered_fields.h"
#include "scene/scene_arrays.h"
#include "scene/validate.h"
#include "scene_file/records.h"
#include "scene_file/section_table.h"
#include "scene_file/verify.h"
#include "tests/scene_file/scene_bytes.h"

namespace dapple {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// Two triangles in the world, prototypes of one and of two more, and something of everything else.
Scene small_model() {
  Scene scene;
  scene.camera.orthographic_height = 3;
  scene.images = {{2, 1, TexelFormat::rgba8, 0, 0}, {1, 2, TexelFormat::rgb32f, 0, 16}};
  scene.texels.resize(40);
  scene.textures.resize(2);
  scene.textures[0].image = ImageId{1};
  scene.textures[1].image = ImageId{0};
  scene.layered_materials.resize(2);
  scene.layered_materials[1].map(MapUse::normal).texture = TextureId{1};
  const MaterialId paint = scene.add_material(Layered{1});
  const MaterialId chalk = scene.add_material(Lambertian{{0.5, 0.5, 0.5}});
  Vertices& v = scene.vertices;
  v.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  v.normals = {{0, 1, 0}, {0, 0, 0}, {0.6f, 0.8f, 0}, {0, 0, -1}};
  v.tangents = {{1, 0, 0, 1}, {1, 0, 0, -1}, {}, {0, 1, 0, 1}};
  v.uvs = {{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{5, -7}, {0, 0}, {0, 0}, {0, 0}}}};
  v.colours.resize(4, {1, 1, 1, 1});
  scene.add_triangle({{0, 1, 2}}, paint);
  scene.add_triangle({{0, 2, 3}}, chalk);
  scene.add_prototype(std::vector<Triangle>{{{1, 2, 3}}}, std::vector{paint});
  scene.add_prototype(std::vector<Triangle>{{{0, 1, 3}}, {{3, 2, 1}}}, std::vector{paint, chalk});
  scene.add_instance({Transformf(), 0});
  scene.add_instance({Transformf(), 1});
  scene.add_cylinder({{0, 0, 0}, {0, 1, 0}, 0.25}, chalk);
  scene.lights.resize(2);
  scene.environment = {EnvironmentKind::image, ImageId{1}, {1, 1, 1}, 90};
  scene.cameras.resize(1);
  scene.cameras[0].name = {'T', 'o', 'p'};
  return scene;
}

// The file that the writer would make if it did not look: sections of a good scene with the bytes
// of a bad one.
std::vector<std::byte> file_of_broken(const Scene& broken) {
  test::FileParts parts(test::scene_bytes(small_model()));
  const auto replace = [&](SectionType type, std::span<const std::byte> bytes, std::size_t count) {
    auto& section = parts.section(type);
    section.bytes.assign(bytes.begin(), bytes.end());
    section.entry.count = count;
    section.entry.size = bytes.size();
  };
  for_each_array(
      [&](SceneArray array, const auto& elements) {
        if (!parts.has(section_of(array))) return;
        replace(section_of(array), std::as_bytes(std::span(elements)), elements.size());
      },
      broken);
  std::vector<RunRecord> runs;
  for (const ObjectRun& run : broken.runs) runs.push_back(encode(run));
  replace(SectionType::runs, std::as_bytes(std::span(runs)), runs.size());
  replace(SectionType::environment, std::as_bytes(std::span(&broken.environment, 1)), 1);
  replace(SectionType::orthographic,
          std::as_bytes(std::span(&broken.camera.orthographic_height, 1)), 1);
  for (std::size_t i = 0; i < broken.materials.size(); ++i) {
    parts.element<MaterialRecord>(SectionType::materials, i) = encode(broken.materials[i]);
  }
  return parts.bytes();
}

void expect_refused(const std::function<void(Scene&)>& change, const std::string& reason) {
  Scene broken = small_model();
  change(broken);
  const Status status = validate(broken);
  ASSERT_FALSE(status) << reason;
  EXPECT_NE(to_string(status.error()).find(reason), std::string::npos) << to_string(status.error());
  const test::AlignedBytes bytes(file_of_broken(broken));
  for (const bool hashes : {true, false}) {
    for (const VerifyScope scope : {VerifyScope::everything, VerifyScope::bvh_only}) {
      const auto loaded = verify(bytes.bytes(), {hashes, scope});
      ASSERT_FALSE(loaded) << reason;
      EXPECT_EQ(loaded.error().code, Errc::bad_data);
      EXPECT_NE(loaded.error().message.find(reason), std::string::npos) << loaded.error().message;
    }
  }
}

void expect_accepted(const std::function<void(Scene&)>& change) {
  Scene scene = small_model();
  change(scene);
  const Status status = validate(scene);
  EXPECT_TRUE(status) << to_string(status.error());
  const test::AlignedBytes bytes(file_of_broken(scene));
  const auto loaded = verify(bytes.bytes());
  EXPECT_TRUE(loaded) << loaded.error().message;
}

TEST(CraftedModel, UnchangedIsAccepted) {
  expect_accepted([](Scene&) {});
}

TEST(CraftedModel, PositionsThatAreNone) {
  for (const float x : {kNan, kInf, -kInf, 1.1e18f}) {
    expect_refused([&](Scene& s) { s.vertices.positions[2].y = x; }, "vertex position 2");
  }
  expect_accepted([](Scene& s) {
    s.vertices.positions[1].z = -1e18f;
    s.instances.clear();  // which would carry it further
    s.runs.erase(s.runs.begin() + 1);
  });
}

TEST(CraftedModel, NormalsThatAreNone) {
  for (const Vec3f n : {Vec3f(0, 1.1f, 0), Vec3f(0, 0, kNan), Vec3f(0.9f, 0, 0), Vec3f(kInf, 0, 0),
                        Vec3f(1e-30f, 0, 0)}) {
    expect_refused([&](Scene& s) { s.vertices.normals[1] = n; }, "vertex normal 1");
  }
  expect_accepted([](Scene& s) { s.vertices.normals[1] = {-0.577f, 0.58f, 0.57f}; });
}

TEST(CraftedModel, TangentsThatAreNone) {
  for (const Vec4f t : {Vec4f{1, 0, 0, 0}, Vec4f{1, 0, 0, 0.5f}, Vec4f{0, 2, 0, 1},
                        Vec4f{0, kNan, 0, 1}, Vec4f{1, 0, 0, kNan}, Vec4f{0, 0, 0, 2}}) {
    expect_refused([&](Scene& s) { s.vertices.tangents[3] = t; }, "vertex tangent 3");
  }
}

TEST(CraftedModel, OtherAttributesThatAreNone) {
  for (const float x : {kNan, kInf}) {
    expect_refused([&](Scene& s) { s.vertices.uvs[0][1].y = x; }, "vertex uv 1");
    expect_refused([&](Scene& s) { s.vertices.uvs[1][0].x = -x; }, "second vertex uv 0");
    expect_refused([&](Scene& s) { s.vertices.colours[2].w = x; }, "vertex colour 2");
  }
  expect_refused([&](Scene& s) { s.vertices.colours[2].x = -0.1f; }, "vertex colour 2");
  expect_accepted([&](Scene& s) { s.vertices.colours[2].x = 10; });
}

TEST(CraftedModel, AttributesThatArePartlyMissing) {
  const auto differ = "attributes and positions differ in number";
  expect_refused([](Scene& s) { s.vertices.normals.pop_back(); }, differ);
  expect_refused([](Scene& s) { s.vertices.tangents.resize(1); }, differ);
  expect_refused([](Scene& s) { s.vertices.uvs[0].pop_back(); }, differ);
  expect_refused([](Scene& s) { s.vertices.uvs[1].resize(9); }, differ);
  expect_refused([](Scene& s) { s.vertices.colours.resize(5); }, differ);
}

TEST(CraftedModel, IndicesOutOfRange) {
  for (const std::uint32_t big : {4u, 0x80000000u, 0xffffffffu}) {
    expect_refused([&](Scene& s) { s.triangles[1].vertices[2] = big; }, "triangle 1");
    expect_refused([&](Scene& s) { s.triangle_materials[4] = MaterialId{big}; }, "of triangle 4");
    expect_refused([&](Scene& s) { s.cylinder_materials[0] = MaterialId{big}; }, "of cylinder");
    expect_refused([&](Scene& s) { s.instances[1].prototype = big; }, "prototype does not exist");
    expect_refused([&](Scene& s) { s.textures[1].image = ImageId{big}; }, "texture 1");
    expect_refused([&](Scene& s) { s.materials[0] = Layered{big}; }, "layered material does not");
    expect_refused([&](Scene& s) { s.environment.image = ImageId{big}; }, "environment: its image");
    expect_refused([&](Scene& s) { s.layered_materials[1].maps[7].uv_set = big; }, "coordinates");
  }
  expect_refused([](Scene& s) { s.layered_materials[0].maps[3].texture = TextureId{2}; },
                 "layered material 0: its normal map: the texture does not exist");
}

TEST(CraftedModel, PrototypesThatDoNotTile) {
  expect_refused([](Scene& s) { s.prototypes[1].first_triangle = 2; }, "prototype 1");
  expect_refused([](Scene& s) { s.prototypes[1].first_triangle = 4; }, "prototype 1");
  expect_refused([](Scene& s) { s.prototypes[1].triangle_count = 1; }, "prototype 1");
  expect_refused([](Scene& s) { s.prototypes[1].triangle_count = 3; }, "prototype 1");
  expect_refused([](Scene& s) { s.prototypes[0].triangle_count = 0; }, "prototype 0");
  expect_refused([](Scene& s) { s.prototypes[0].triangle_count = 0xffffffff; }, "prototype 0");
  expect_refused([](Scene& s) { s.prototypes[0].first_triangle = 0xffffffff; }, "prototype 0");
  const auto one_earlier = [](Scene& s) { s.prototypes = {{1, 2}, {3, 2}}; };
  expect_refused(one_earlier, "triangle objects disagree");
}

TEST(CraftedModel, TransformsWithoutInverse) {
  const auto refused = [](float value) {
    expect_refused([&](Scene& s) { s.instances[0].to_world.rows[1][1] = value; }, "transform");
  };
  for (const float value : {0.0f, kNan, kInf, 2e18f, 1e-30f}) refused(value);
  expect_refused([](Scene& s) { s.instances[0].to_world.rows[2][3] = kInf; }, "transform");
  expect_refused(
      [](Scene& s) {
        for (auto& row : s.instances[1].to_world.rows) row[0] = row[1] = row[2] = 1;
      },
      "transform");
  expect_accepted([](Scene& s) { s.instances[0].to_world.rows[1][1] = -1e-9f; });  // mirrors too
}

TEST(CraftedModel, InstancesThatReachTooFar) {
  const auto moved_far = [](float scale) {
    return [scale](Scene& s) {
      s.instances[1].to_world.rows[0][0] = scale;
      s.instances[1].to_world.rows[0][3] = -9e17f;
    };
  };
  expect_refused(moved_far(1.1e17f), "reaches beyond");
  expect_accepted(moved_far(0.9e17f));
  // Only the vertices of the prototype count.
  const auto far_vertex = [](Scene& s) {
    s.vertices.positions[0].x = 5e17f;
    s.instances[1].prototype = 0;  // of vertices 1, 2 and 3
    s.instances[0].to_world.rows[0][0] = 4;
  };
  expect_accepted(far_vertex);
  expect_refused(
      [&](Scene& s) {
        far_vertex(s);
        s.instances[0].prototype = 1;
      },
      "reaches beyond");
}

TEST(CraftedModel, CylindersThatAreNone) {
  expect_refused([](Scene& s) { s.cylinders[0].radius = -1; }, "cylinder");
  expect_refused([](Scene& s) { s.cylinders[0].radius = 2e18; }, "cylinder");
  expect_refused([](Scene& s) { s.cylinders[0].end.z = kNan; }, "cylinder");
}

TEST(CraftedModel, LayeredNumbersOutOfRange) {
  for (const LayeredNumber& number : layered_numbers()) {
    const auto refused = [&](float value) {
      expect_refused([&](Scene& s) { s.layered_materials[0].*number.member = value; },
                     fmt::format("its {} is out of range", number.name));
    };
    refused(kNan);
    refused(-kInf);
    if (number.low >= 0) refused(-0.001f);
    if (number.high == 1) refused(1.001f);
    if (number.high < kInf) refused(kInf);
  }
  for (const LayeredColour& colour : layered_colours()) {
    for (const float value : {kNan, kInf, -0.001f}) {
      expect_refused([&](Scene& s) { (s.layered_materials[1].*colour.member).y = value; },
                     fmt::format("its {} is out of range", colour.name));
    }
  }
}

TEST(CraftedModel, LayeredTagsOutOfRange) {
  expect_refused([](Scene& s) { s.layered_materials[1].model = BaseModel{2}; }, "model");
  expect_refused([](Scene& s) { s.layered_materials[1].alpha_mode = AlphaMode{3}; }, "alpha mode");
  expect_refused([](Scene& s) { s.layered_materials[1].unlit = 2; }, "switch");
  expect_refused([](Scene& s) { s.layered_materials[1].double_sided = 0x100; }, "switch");
  for (const float value : {kNan, kInf}) {
    expect_refused([&](Scene& s) { s.layered_materials[0].maps[17].to_uv[1][2] = value; },
                   "diffuse_transmission_colour map: the transform");
  }
}

TEST(CraftedModel, TexturesOfUnknownKinds) {
  expect_refused([](Scene& s) { s.textures[0].wrap_u = Wrap{3}; }, "texture 0");
  expect_refused([](Scene& s) { s.textures[0].wrap_v = Wrap{0xffffffff}; }, "texture 0");
  expect_refused([](Scene& s) { s.textures[0].filter = Filter{2}; }, "texture 0");
}

TEST(CraftedModel, ImagesThatDoNotTile) {
  expect_refused([](Scene& s) { s.images[1].offset = 8; }, "image 1");
  expect_refused([](Scene& s) { s.images[1].offset = 0; }, "image 1");
  expect_refused([](Scene& s) { s.images[1].offset = 32; }, "image 1");
  expect_refused([](Scene& s) { s.images[1].offset = ~std::uint64_t{15}; }, "image 1");
  expect_refused([](Scene& s) { s.images[0].offset = 16; }, "image 0");
  expect_refused([](Scene& s) { s.images[1].height = 3; }, "image 1");
  expect_refused([](Scene& s) { s.images[1].format = TexelFormat{3}; }, "image 1");
  expect_refused([](Scene& s) { s.images[1].reserved = 1; }, "image 1");
  expect_refused([](Scene& s) { s.images[0].width = 0; }, "image 0");
  expect_refused([](Scene& s) { s.images[0].width = 0xffffffff; }, "image 0");
  expect_refused([](Scene& s) { s.texels.pop_back(); }, "image 1");
  expect_refused([](Scene& s) { s.texels.resize(s.texels.size() + 16); }, "image 1");
  expect_accepted([](Scene& s) { s.texels.resize(48); });  // rounded up
}

TEST(CraftedModel, TexelsOfNoImage) {
  Scene scene;
  scene.texels.resize(100);
  EXPECT_FALSE(validate(scene));
}

TEST(CraftedModel, LightsThatAreNone) {
  expect_refused([](Scene& s) { s.lights[1].kind = LightKind{3}; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].position.x = kNan; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].position.x = 2e18f; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].direction = {0, 0, 0}; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].direction = {0, 2, 0}; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].intensity.y = -1; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].intensity.z = kInf; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].inner_angle = 1; }, "light 1");  // beyond the outer
  expect_refused([](Scene& s) { s.lights[1].inner_angle = -1; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].outer_angle = 4; }, "light 1");
  expect_refused([](Scene& s) { s.lights[1].outer_angle = kNan; }, "light 1");
}

TEST(CraftedModel, EnvironmentThatIsNone) {
  expect_refused([](Scene& s) { s.environment.kind = EnvironmentKind{5}; }, "environment");
  expect_refused([](Scene& s) { s.environment.image = kNoImage; }, "environment");
  expect_refused([](Scene& s) { s.environment.colour.x = -1; }, "environment");
  expect_refused([](Scene& s) { s.environment.rotation = kNan; }, "environment");
}

TEST(CraftedModel, CamerasThatAreNone) {
  expect_refused([](Scene& s) { s.camera.orthographic_height = -1; }, "height");
  expect_refused([](Scene& s) { s.camera.orthographic_height = kInf; }, "height");
  expect_refused([](Scene& s) { s.cameras[0].camera.look_at.x = kNan; }, "camera 0");
  expect_refused([](Scene& s) { s.cameras[0].camera.orthographic_height = kNan; }, "camera 0");
  expect_refused([](Scene& s) { s.cameras[0].name.fill('x'); }, "camera 0: its name does not end");
  expect_refused([](Scene& s) { s.cameras[0].name[40] = 'x'; }, "camera 0: its name does not end");
  expect_refused([](Scene& s) { s.cameras[0].name[1] = '\xff'; }, "not UTF-8");
  expect_refused([](Scene& s) { s.cameras[0].name[2] = '\xc3'; }, "not UTF-8");
}

// Where there can be one at most.
TEST(CraftedModel, TwoOfWhatThereIsOneOf) {
  for (const SectionType type : {SectionType::environment, SectionType::orthographic}) {
    test::FileParts parts(test::scene_bytes(small_model()));
    auto& section = parts.section(type);
    section.bytes.insert(section.bytes.end(), section.bytes.begin(), section.bytes.end());
    section.entry.count = 2;
    section.entry.size *= 2;
    const auto loaded = verify(test::AlignedBytes(parts.bytes()).bytes());
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().message.find("one"), std::string::npos) << loaded.error().message;
  }
}

TEST(CraftedModel, LayeredIndexThatIsNoWholeNumber) {
  for (const double index : {0.5, -1.0, -0.0, 4294967296.0, 1e300, double{kNan}}) {
    test::FileParts parts(test::scene_bytes(small_model()));
    parts.element<MaterialRecord>(SectionType::materials, 0).numbers[0] = index;
    const auto loaded = verify(test::AlignedBytes(parts.bytes()).bytes());
    ASSERT_FALSE(loaded) << index;
    EXPECT_NE(loaded.error().message.find("material 0: its index"), std::string::npos);
  }
}

// Each section of arrays taken out: refused, unless nothing refers to what was in it.
TEST(CraftedModel, SectionsThatAreMissing) {
  const auto whole = test::scene_bytes(small_model());
  for (const SectionKind& kind : section_kinds()) {
    test::FileParts parts(whole);
    if (!kind.array || !parts.has(kind.type)) continue;
    std::erase_if(parts.sections, [&](const auto& s) {
      return s.entry.type == static_cast<std::uint32_t>(kind.type);
    });
    const bool may_be_missing =
        kind.type == SectionType::normals || kind.type == SectionType::tangents ||
        kind.type == SectionType::uvs0 || kind.type == SectionType::uvs1 ||
        kind.type == SectionType::colours || kind.type == SectionType::lights ||
        kind.type == SectionType::cameras;
    const bool accepted = verify(test::AlignedBytes(parts.bytes()).bytes()).has_value();
    EXPECT_EQ(accepted, may_be_missing) << kind.name;
  }
}

// Counted before any is read: there is only one.
TEST(Validate, MoreThanThereIsRoomFor) {
  const auto place_of_error = [](const SceneView& view) {
    const Status status = validate(view);
    return status ? std::string() : status.error().place;
  };
  const Material material = Dielectric{1.5};
  SceneView materials;
  materials.materials = {&material, kMaxMaterialCount + 1};
  EXPECT_EQ(place_of_error(materials), "materials");
  const Instance instance;
  SceneView instances;
  instances.instances = {&instance, kMaxInstanceCount + 1};
  EXPECT_EQ(place_of_error(instances), "instances");
}

}  // namespace
}  // namespace dapple
