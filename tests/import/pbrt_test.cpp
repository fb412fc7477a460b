#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "image/formats.h"
#include "import/registry.h"
#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

const std::string kTriangle =
    "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]\n";

class Pbrt : public testing::Test {
 protected:
  Expected<ImportResult> import(const std::string& text, const ImportOptions& options = {}) {
    put_file(folder_ / "s.pbrt", text);
    return import_scene(folder_ / "s.pbrt", options);
  }
  Scene scene(const std::string& text) {
    auto result = import(text);
    EXPECT_TRUE(result) << to_string(result.error());
    return result ? std::move(result->scene) : Scene();
  }
  LayeredMaterial material(const std::string& text) {
    const Scene s = scene("WorldBegin\n" + text + kTriangle);
    if (s.layered_materials.empty()) return {};
    return s.layered_materials[0];
  }
  void expect_error(const std::string& text, std::size_t line, const std::string& part) {
    const auto result = import(text);
    ASSERT_FALSE(result) << text;
    EXPECT_EQ(result.error().place, (folder_ / "s.pbrt:") + std::to_string(line));
    EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
  }
  TemporaryFolder folder_;
};

TEST_F(Pbrt, DamageIsNamedWithItsLine) {
  expect_error("WorldBegin\nFoo\n", 2, "'Foo'");
  expect_error("[\n", 1, "directive");
  expect_error("WorldBegin\nTranslate 1 2\n", 3, "ends within");
  expect_error("WorldBegin\nTranslate 1 2 x\n", 2, "'x'");
  expect_error("Scale 1e999 1 1\n", 1, "finite");
  expect_error("AttributeEnd\n", 1, "without a beginning");
  expect_error("Shape \"sphere\" \"float radius\" [1\n", 1, "ends within");
  expect_error("Shape \"sphere\" \"float radius\" [\"a\"]\n", 1, "number");
  expect_error("Shape \"sphere\" \"radius\" [1]\n", 1, "type and name");
  expect_error("Shape \"sphere\n", 1, "quotation");
  expect_error("Shape sphere\n", 1, "lacks a text");
  expect_error("\nNamedMaterial \"none\"\n", 2, "no material");
  expect_error("ObjectInstance \"none\"\n", 1, "no object");
  expect_error("Scale 0 1 1 Camera \"perspective\"\n", 1, "inverse");
  expect_error("Scale 1 1 0\n" + kTriangle, 2, "inverse");
  expect_error("LookAt 0 0 0 0 1 0 0 1 0\n", 1, "affine");
  expect_error("Transform [1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1]\n", 1, "affine");
  expect_error("Shape \"trianglemesh\" \"point3 P\" [0 0 0] \"integer indices\" [0 0 1]\n", 1,
               "index 1 of 1");
  expect_error("Shape \"trianglemesh\" \"point3 P\" [0 0 0] \"integer indices\" [0 0]\n", 1,
               "multiple of 3");
  expect_error("Shape \"plymesh\" \"string filename\" \"../x.ply\"\n", 1, "outside");
  expect_error("Include \"none.pbrt\"\n", 1, "none.pbrt");
  expect_error("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"t.png\"\n", 1,
               "t.png");
  expect_error("Material \"diffuse\" \"texture reflectance\" \"t\"\n", 1, "no texture");
  expect_error("Material \"diffuse\" \"rgb reflectance\" [1 1]\n", 1, "three numbers");
}

TEST_F(Pbrt, FacesWithIndicesOfNothingCanBeLeftOut) {
  const std::string text =
      "WorldBegin\nShape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] "
      "\"integer indices\" [0 1 3 0 1 2 -1 1 2]\n";
  EXPECT_FALSE(import(text));
  ImportOptions options;
  options.keep_going = true;
  const auto result = import(text, options);
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->scene.triangles.size(), 1u);
  ASSERT_EQ(result->warnings.size(), 1u);
  EXPECT_NE(result->warnings[0].find("s.pbrt:2: 2 faces with indices of nothing"),
            std::string::npos)
      << result->warnings[0];
}

TEST_F(Pbrt, FilesThatIncludeThemselvesEnd) {
  expect_error("Include \"s.pbrt\"\n", 1, "too many included files");
}

// Where a camera sees a point: to its right, above it, before it.
Vec3d seen(const Camera& camera, const Vec3d& point) {
  const Vec3d forward = normalize(camera.look_at - camera.look_from);
  const Vec3d right = normalize(cross(forward, camera.up));
  const Vec3d offset = point - camera.look_from;
  return {dot(offset, right), dot(offset, cross(right, forward)), dot(offset, forward)};
}

TEST_F(Pbrt, CamerasSeeWhatTheySawInPbrt) {
  // In the camera's own space x is to the right, y up and z ahead.
  const std::string views[] = {"",
                               "Scale -1 1 1",
                               "Scale 1 1 -1 Rotate 30 1 2 3",
                               "LookAt 1 2 3 4 5 7 0 1 0",
                               "Scale -1 1 1 LookAt 0 2 15 0 1 14 0 1 0",
                               "Scale -1 1 1 LookAt 1 2 3 0 0 0 0 0 1 Scale -1 1 1",
                               "Rotate 200 0 0 1 Translate 3 4 5 Scale 2 2 2"};
  for (const std::string& view : views) {
    // The inverse of the view brings a point of the camera's space into the world.
    const std::string sphere =
        "CoordSysTransform \"camera\" Translate 1 2 3 "
        "Shape \"sphere\" \"float radius\" [0.1]\n";
    const Scene s = scene(view + " Camera \"perspective\" WorldBegin\n" + sphere);
    ASSERT_EQ(s.spheres.size(), 1u) << view;
    const Vec3d at = seen(s.camera, s.spheres[0].centre);
    EXPECT_NEAR(at.x / at.z, 1.0 / 3, 1e-9) << view;
    EXPECT_NEAR(at.y / at.z, 2.0 / 3, 1e-9) << view;
    EXPECT_GT(at.z, 0) << view;
  }
}

TEST_F(Pbrt, OutsideStaysOutside) {
  const std::string cameras[] = {"Camera \"perspective\"", "Scale -1 1 1 Camera \"perspective\""};
  const std::string moves[] = {"", "Scale -1 1 1", "Scale 2 -3 1 Rotate 40 1 1 0",
                               "Scale -1 -1 -1"};
  for (const std::string& camera : cameras) {
    for (const std::string& move : moves) {
      for (const std::string reversed : {"", "ReverseOrientation "}) {
        // The triangle's normal is z; the small sphere marks the side that it looks to.
        const Scene s = scene(camera + " WorldBegin " + move + " " + reversed + kTriangle +
                              "Translate 0 0 0.001 Shape \"disk\" \"float radius\" 0.001");
        ASSERT_GT(s.triangles.size(), 1u);
        const auto corner = [&](std::size_t triangle, std::size_t i) {
          return Vec3d(s.vertices.positions[s.triangles[triangle].vertices[i]]);
        };
        const Vec3d normal = cross(corner(0, 1) - corner(0, 0), corner(0, 2) - corner(0, 0));
        const double side = dot(normal, corner(1, 0) - corner(0, 0));
        EXPECT_EQ(side > 0, reversed.empty()) << camera << move << reversed;
        const Vec3d disc = cross(corner(1, 1) - corner(1, 0), corner(1, 2) - corner(1, 0));
        EXPECT_GT(dot(normal, disc), 0);
        EXPECT_GT(dot(disc, Vec3d(s.vertices.normals[s.triangles[1].vertices[0]])), 0);
      }
    }
  }
}

TEST_F(Pbrt, AFieldOfViewCountsAcrossTheShorterSide) {
  const auto fov = [&](const std::string& film) {
    return scene(film + "Camera \"perspective\" \"float fov\" 40\nWorldBegin\n" + kTriangle)
        .camera.vertical_fov;
  };
  const std::string wide = "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100\n";
  const std::string tall = "Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 200\n";
  EXPECT_NEAR(fov(wide), 40, 1e-9);
  constexpr double kHalfTurn = 3.14159265358979;
  const double expected = 360 / kHalfTurn * std::atan(2 * std::tan(20 * kHalfTurn / 180));
  EXPECT_NEAR(fov(tall), expected, 1e-6);
  const auto result = import(tall + "WorldBegin\n" + kTriangle);
  ASSERT_TRUE(result && result->pictures.resolution);
  EXPECT_EQ(*result->pictures.resolution, (std::array<int, 2>{100, 200}));
}

TEST_F(Pbrt, MediaThatFillNothingAreWarnings) {
  const auto warnings = [&](const std::string& interfaces) {
    const auto result = import(
        "WorldBegin\nMakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\n" + interfaces);
    if (!result) return to_string(result.error());
    std::string text;
    for (const std::string& warning : result->warnings) text += warning + "\n";
    return text;
  };
  const std::string in_fog = "MediumInterface \"\" \"fog\" Material \"dielectric\"\n" + kTriangle;
  EXPECT_NE(warnings(in_fog).find("inside of none"), std::string::npos);
  EXPECT_EQ(warnings(in_fog + "MediumInterface \"fog\" \"\" Material \"interface\"\n" + kTriangle),
            "");
}

TEST_F(Pbrt, MaterialsBecomeLayered) {
  const LayeredMaterial diffuse = material("Material \"diffuse\" \"rgb reflectance\" [.1 .2 .3]\n");
  EXPECT_EQ(diffuse.base_colour, Vec3f(.1f, .2f, .3f));
  EXPECT_EQ(diffuse.specular, 0);
  const LayeredMaterial rough =
      material("Material \"conductor\" \"float roughness\" .16 \"bool remaproughness\" false\n");
  EXPECT_EQ(rough.metallic, 1);
  EXPECT_FLOAT_EQ(rough.roughness, 0.4f);
  EXPECT_FLOAT_EQ(material("Material \"conductor\" \"float roughness\" .0625\n").roughness,
                  std::sqrt(0.25f));
  const LayeredMaterial glass = material("Material \"dielectric\" \"float eta\" 1.3\n");
  EXPECT_EQ(glass.transmission, 1);
  EXPECT_EQ(glass.ior, 1.3f);
  EXPECT_GT(glass.thickness, 0);
  EXPECT_EQ(material("Material \"thindielectric\"\n").thickness, 0);
  const LayeredMaterial coated =
      material("Material \"coateddiffuse\" \"rgb reflectance\" [0.5 0 1]\n");
  EXPECT_EQ(coated.specular, 1);
  EXPECT_LT(coated.base_colour.x, 0.5f);
  EXPECT_EQ(coated.base_colour.y, 0);
  EXPECT_FLOAT_EQ(coated.base_colour.z, 1);
  const LayeredMaterial leaf = material(
      "Material \"diffusetransmission\" \"rgb reflectance\" [.3 .3 .3] \"rgb transmittance\" "
      "[.1 .1 .1]\n");
  EXPECT_NEAR(leaf.base_colour.x * (1 - leaf.diffuse_transmission), 0.3f, 1e-6f);
  EXPECT_NEAR(leaf.diffuse_transmission_colour.x * leaf.diffuse_transmission, 0.1f, 1e-6f);
}

TEST_F(Pbrt, WhatIsNotUnderstoodIsAWarningWithItsPlace) {
  const auto result = import(
      "WorldBegin\nMaterial \"hair\"\nShape \"curve\"\n"
      "Material \"diffuse\" \"float foo\" 1\n" +
      kTriangle);
  ASSERT_TRUE(result) << to_string(result.error());
  ASSERT_EQ(result->warnings.size(), 3u);
  EXPECT_NE(result->warnings[0].find("s.pbrt:2"), std::string::npos);
  EXPECT_NE(result->warnings[1].find("s.pbrt:3"), std::string::npos);
  EXPECT_NE(result->warnings[2].find("'foo'"), std::string::npos);
}

TEST_F(Pbrt, LightsAreWhatTheFileSays) {
  const Scene lamps = scene(
      "WorldBegin\nLightSource \"point\" \"rgb I\" [1 2 3] \"float scale\" 2 \"point3 from\" [1 2 "
      "3]\n"
      "LightSource \"distant\" \"point3 from\" [0 5 0] \"point3 to\" [0 0 0]\n"
      "LightSource \"spot\" \"float coneangle\" 60 \"float conedeltaangle\" 20\n" +
      kTriangle);
  ASSERT_EQ(lamps.lights.size(), 3u);
  EXPECT_EQ(lamps.lights[0].intensity, Vec3f(2, 4, 6));
  EXPECT_EQ(lamps.lights[1].direction, Vec3f(0, -1, 0));
  EXPECT_NEAR(lamps.lights[2].outer_angle, 1.0471976f, 1e-6f);
  EXPECT_NEAR(lamps.lights[2].inner_angle, 0.6981317f, 1e-6f);
  EXPECT_EQ(lamps.environment.kind, EnvironmentKind::none);
  const Scene sky = scene("LightSource \"infinite\" \"rgb L\" [1 2 3]\n" + kTriangle);
  EXPECT_EQ(sky.environment.kind, EnvironmentKind::constant);
  EXPECT_EQ(sky.environment.colour, Vec3f(1, 2, 3));
  const Scene lamp =
      scene("AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] \"float scale\" 0.5\n" + kTriangle);
  EXPECT_EQ(lamp.layered_materials[0].emission, Vec3f(2, 2, 2));
  EXPECT_EQ(lamp.environment.kind, EnvironmentKind::none);
  EXPECT_EQ(scene(kTriangle).environment.kind, EnvironmentKind::studio);
}

TEST_F(Pbrt, ObjectsAreStoredOnce) {
  const Scene s =
      scene("ObjectBegin \"o\" " + kTriangle + " Translate 0 0 1 " + kTriangle +
            "ObjectEnd ObjectInstance \"o\" Translate 5 0 0 ObjectInstance \"o\"\n" + kTriangle);
  EXPECT_EQ(s.prototypes.size(), 1u);
  EXPECT_EQ(s.instances.size(), 2u);
  EXPECT_EQ(s.triangles.size(), 3u);
  EXPECT_EQ(s.prototypes[0].first_triangle, 1u);
  EXPECT_EQ(s.instances[1].to_world.rows[0][3], 5);
}

TEST_F(Pbrt, MediaFillWhatLetsLightIn) {
  const LayeredMaterial fog = material(
      "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [1 2 4] "
      "\"rgb sigma_s\" [3 2 1] \"float scale\" 0.5 \"float g\" 0.25\n"
      "MediumInterface \"fog\" \"\" Material \"interface\"\n");
  EXPECT_EQ(fog.scattering, Vec3f(1.5f, 1, 0.5f));
  EXPECT_EQ(fog.scattering_anisotropy, 0.25f);
  const Vec3f& left = fog.attenuation_colour;
  for (int i = 0; i < 3; ++i) {
    const double absorption = -std::log(double(left[i])) / double(fog.attenuation_distance);
    EXPECT_NEAR(absorption, 0.5 * (i == 0 ? 1 : i == 1 ? 2 : 4), 1e-5);
  }
  EXPECT_EQ(fog.ior, 1);
}

TEST_F(Pbrt, AnInterfaceBetweenNothingAndNothingIsNotThere) {
  const Scene s =
      scene("Material \"interface\"\n" + kTriangle + "Material \"diffuse\"\n" + kTriangle);
  EXPECT_EQ(s.triangles.size(), 1u);
}

// The unit square folded onto the sphere so that areas keep their proportions; from [Clarberg08],
// apart from the importer's own inverse of it.
Vec3d from_square(double u, double v) {
  constexpr double kQuarter = 0.785398163397448;
  u = 2 * u - 1, v = 2 * v - 1;
  const double up = std::fabs(u), vp = std::fabs(v), distance = 1 - (up + vp);
  const double d = std::fabs(distance), r = 1 - d;
  const double phi = (r == 0 ? 1 : (vp - up) / r + 1) * kQuarter;
  const double z = std::copysign(1 - r * r, distance);
  const double side = r * std::sqrt(2 - r * r);
  return {std::copysign(std::cos(phi), u) * side, std::copysign(std::sin(phi), v) * side, z};
}

TEST_F(Pbrt, EnvironmentsAreTurnedRightSideUp) {
  // Each texel's colour is its own direction, so any mistake of direction shows.
  Image image(128, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      image.at(x, y) = Vec3f(Vec3d(1, 1, 1) + from_square((x + 0.5) / 128, (y + 0.5) / 128));
    }
  }
  ASSERT_TRUE(write_image(folder_ / "sky.pfm", image, {}));
  const Scene s = scene(
      "Camera \"perspective\" WorldBegin Rotate 90 0 1 0\nLightSource \"infinite\" "
      "\"string filename\" \"sky.pfm\"\n" +
      kTriangle);
  ASSERT_EQ(s.images.size(), 1u);
  const TextureImage& map = s.images[0];
  ASSERT_EQ(map.format, TexelFormat::rgb32f);
  constexpr double kHalfTurn = 3.14159265358979;
  for (std::uint32_t y = 0; y < map.height; y += 5) {
    for (std::uint32_t x = 0; x < map.width; x += 5) {
      const double theta = kHalfTurn * (y + 0.5) / map.height;
      const double phi = 2 * kHalfTurn * ((x + 0.5) / map.width - 0.5);
      const Vec3d d(std::sin(theta) * std::cos(phi), std::cos(theta),
                    std::sin(theta) * std::sin(phi));
      // Turned by 90 degrees about y, then mirrored in z.
      const Vec3d expected(d.z, d.y, d.x);
      Vec3f texel;
      std::memcpy(&texel, s.texels.data() + map.offset + (y * map.width + x) * sizeof texel,
                  sizeof texel);
      EXPECT_NEAR(double(texel.x) - 1, expected.x, 0.03) << x << ' ' << y;
      EXPECT_NEAR(double(texel.y) - 1, expected.y, 0.03) << x << ' ' << y;
      EXPECT_NEAR(double(texel.z) - 1, expected.z, 0.03) << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace dapple
