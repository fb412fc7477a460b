// Files whose checksums are all right and whose contents are not: each check on its own.
#include <gtest/gtest.h>

#include <limits>

#include "scene/named_scenes.h"
#include "scene_file/verify.h"
#include "tests/scene_file/scene_bytes.h"

namespace dapple {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// Refused with and without checksums, for a reason with `reason` in it.
void expect_refused(const std::vector<std::byte>& file, const std::string& reason) {
  const test::AlignedBytes bytes(file);
  for (const bool hashes : {true, false}) {
    const auto loaded = verify(bytes.bytes(), {hashes, VerifyScope::everything});
    ASSERT_FALSE(loaded) << reason;
    EXPECT_EQ(loaded.error().code, Errc::bad_data);
    EXPECT_NE(loaded.error().message.find(reason), std::string::npos) << loaded.error().message;
  }
}

test::FileParts nice() { return test::FileParts(test::scene_bytes(*make_named_scene("nice"))); }

// Changes to the section table.
void expect_table_refused(const std::function<void(std::span<SectionEntry>)>& change,
                          const std::string& reason) {
  expect_refused(nice().bytes(change), reason);
}

TEST(Crafted, UnchangedPartsAreAccepted) {
  EXPECT_TRUE(verify(test::AlignedBytes(nice().bytes()).bytes()));
}

TEST(Crafted, WrongChecksumIsFoundUnlessTrusted) {
  const auto file = nice().bytes([](auto table) { table[2].hash ^= 1; });
  const test::AlignedBytes bytes(file);
  EXPECT_FALSE(verify(bytes.bytes()));
  EXPECT_TRUE(verify(bytes.bytes(), {false, VerifyScope::everything}));
}

TEST(Crafted, OverlappingSections) {
  expect_table_refused([](auto table) { table[3].offset = table[2].offset; },
                       "does not begin right after");
}

TEST(Crafted, SectionsOutOfOrder) {
  expect_table_refused([](auto table) { std::swap(table[2], table[3]); },
                       "does not begin right after");
}

TEST(Crafted, HiddenSpaceBetweenSections) {
  expect_table_refused([](auto table) { table[4].offset += 64; }, "does not begin right after");
}

TEST(Crafted, SectionBeyondTheEnd) {
  expect_table_refused(
      [](auto table) {
        table.back().count = 1000;
        table.back().size = 1000 * table.back().stride;
      },
      "beyond the end");
}

TEST(Crafted, OffsetThatWrapsRound) {
  expect_table_refused([](auto table) { table[3].offset = ~std::uint64_t{63}; },
                       "does not begin right after");
}

TEST(Crafted, CountTimesStrideThatWrapsRound) {
  // 40 * 2^61 is 0 modulo 2^64.
  expect_table_refused(
      [](auto table) {
        table[1].count = std::uint64_t{1} << 61;
        table[1].size = 0;
      },
      "count times stride");
}

TEST(Crafted, MorePromisedThanPresent) {
  expect_table_refused([](auto table) { table[3].count += 1; }, "count times stride");
}

TEST(Crafted, StrideOfAnotherKind) {
  expect_table_refused(
      [](auto table) {
        table[3].stride = 16;
        table[3].count *= 2;
      },
      "wrong stride");
}

TEST(Crafted, ZeroStride) {
  expect_table_refused([](auto table) { table[3].stride = 0; }, "count times stride");
}

TEST(Crafted, AlignmentThatIsNone) {
  for (const std::uint32_t alignment : {0u, 1u, 63u, 96u, 1u << 22, 1u << 31}) {
    expect_table_refused([&](auto table) { table[0].alignment = alignment; }, "alignment");
  }
}

TEST(Crafted, UnknownFlags) {
  expect_table_refused([](auto table) { table[0].flags |= 2; }, "unknown flags");
}

TEST(Crafted, KnownSectionMarkedAsIgnorable) {
  expect_table_refused([](auto table) { table[0].flags = 0; }, "wrong flags");
}

TEST(Crafted, ReservedTableFields) {
  expect_table_refused([](auto table) { table[0].reserved[1] = 1; }, "reserved");
}

TEST(Crafted, UnknownCriticalSection) {
  expect_table_refused([](auto table) { table[3].type = section_type("MESH"); },
                       "section MESH is not known");
}

TEST(Crafted, SectionThatIsThereTwice) {
  auto parts = nice();
  parts.sections.push_back(parts.section(SectionType::materials));
  expect_refused(parts.bytes(), "twice");
}

TEST(Crafted, UnknownSectionThatMayBeIgnoredIs) {
  auto parts = nice();
  test::FileParts::Section extra;
  extra.bytes.resize(300, std::byte{7});
  extra.entry = {section_type("NOTE"), 0, 0, 300, 300, 1, 4096, 0, {}};
  parts.sections.insert(parts.sections.begin() + 2, extra);
  const test::AlignedBytes file(parts.bytes());
  const auto loaded = verify(file.bytes());
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(test::same_scene(loaded->view, *make_named_scene("nice")));
  // Its checksum counts all the same.
  auto damaged = parts.bytes([](auto table) { table[2].hash ^= 1; });
  EXPECT_FALSE(verify(test::AlignedBytes(damaged).bytes()));
}

TEST(Crafted, PaddingThatIsNotZero) {
  auto file = nice().bytes();
  test::FileParts parts(file);
  const SectionEntry& camera = parts.section(SectionType::camera).entry;
  file[camera.offset + camera.size] = std::byte{1};
  expect_refused(file, "padding");
}

TEST(Crafted, TooManySections) {
  auto parts = nice();
  for (std::uint32_t i = 0; i < kMaxSectionCount; ++i) {
    test::FileParts::Section extra;
    extra.entry = {section_type("A\0\0\0") + (i << 8), 0, 0, 0, 0, 1, 64, 0, {}};
    parts.sections.push_back(extra);
  }
  expect_refused(parts.bytes(), "sections are more than");
}

TEST(Crafted, TableBeyondTheEnd) {
  FileHeader header = nice().header;
  header.file_size = sizeof(header);
  header.section_count = 3;
  std::vector<std::byte> file(sizeof(header));
  std::memcpy(file.data(), &header, sizeof(header));
  const test::AlignedBytes bytes(file);
  const auto loaded = verify(bytes.bytes(), {false, VerifyScope::everything});
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().message.find("section table reaches"), std::string::npos);
}

TEST(Crafted, ReservedHeaderFields) {
  auto parts = nice();
  parts.header.reserved = 1;
  expect_refused(parts.bytes(), "reserved header fields");
  parts = nice();
  parts.header.reserved2[1] = 1;
  expect_refused(parts.bytes(), "reserved header fields");
}

TEST(Crafted, OtherEndianness) {
  auto parts = nice();
  parts.header.endian_mark = 0x04030201;
  expect_refused(parts.bytes(), "endian");
}

TEST(Crafted, FutureMajorVersionNamesBoth) {
  auto parts = nice();
  parts.header.major = 7;
  parts.header.minor = 3;
  expect_refused(parts.bytes(), "version 7.3");
  expect_refused(parts.bytes(), "version 1.x");
}

TEST(Crafted, FutureMinorVersionIsRead) {
  auto parts = nice();
  parts.header.minor = 9;
  EXPECT_TRUE(verify(test::AlignedBytes(parts.bytes()).bytes()));
}

TEST(Crafted, NoCamera) {
  auto parts = nice();
  parts.sections.erase(parts.sections.begin());
  expect_refused(parts.bytes(), "one camera");
}

TEST(Crafted, CameraThatIsNone) {
  const auto expect_camera_refused = [](auto change) {
    auto parts = nice();
    change(parts.element<CameraRecord>(SectionType::camera));
    expect_refused(parts.bytes(), "camera");
  };
  expect_camera_refused([](CameraRecord& c) { c.look_at[2] = kNan; });
  expect_camera_refused([](CameraRecord& c) { c.look_from[0] = 2e18; });
  expect_camera_refused([](CameraRecord& c) { c.up[1] = -kInf; });
  expect_camera_refused([](CameraRecord& c) { c.vertical_fov = 180; });
  expect_camera_refused([](CameraRecord& c) { c.aperture = -1; });
  expect_camera_refused([](CameraRecord& c) { c.focus_distance = 0; });
}

TEST(Crafted, MaterialThatIsNone) {
  const auto expect_material_refused = [](auto change) {
    auto parts = nice();
    change(parts.element<MaterialRecord>(SectionType::materials, 2));
    expect_refused(parts.bytes(), "material 2");
  };
  expect_material_refused([](MaterialRecord& m) { m.tag = 3; });
  expect_material_refused([](MaterialRecord& m) { m.tag = 0xffffffff; });
  expect_material_refused([](MaterialRecord& m) { m.reserved = 1; });
  expect_material_refused([](MaterialRecord& m) { m.numbers[1] = kInf; });
  expect_material_refused([](MaterialRecord& m) { m.numbers[3] = -0.0; });  // unused
}

TEST(Crafted, MaterialIdOutOfRange) {
  for (const SectionType type : {SectionType::sphere_materials, SectionType::xy_rectangle_materials,
                                 SectionType::yz_rectangle_materials}) {
    for (const std::uint32_t id : {4u, 0x80000000u, 0xffffffffu}) {
      auto parts = nice();
      parts.element<std::uint32_t>(type) = id;
      expect_refused(parts.bytes(), "material id");
    }
  }
}

TEST(Crafted, ShapesWithoutMaterials) {
  auto parts = nice();
  std::erase_if(parts.sections, [](const auto& s) {
    return s.entry.type == static_cast<std::uint32_t>(SectionType::sphere_materials);
  });
  expect_refused(parts.bytes(), "counts of sphere objects disagree");
}

TEST(Crafted, NoMaterialsAtAll) {
  auto parts = nice();
  parts.sections.erase(parts.sections.begin() + 1);
  expect_refused(parts.bytes(), "material id");
}

TEST(Crafted, CoordinatesThatAreNone) {
  for (const double value : {kNan, kInf, -kInf, 1.0000001e18, -1e300}) {
    for (std::size_t i = 0; i < 4; ++i) {
      auto parts = nice();
      parts.element<double>(SectionType::spheres, i) = value;
      expect_refused(parts.bytes(), "not finite or beyond 1e+18");
    }
    for (std::size_t i = 0; i < 10; ++i) {
      auto parts = nice();
      parts.element<double>(SectionType::yz_rectangles, i) = value;
      expect_refused(parts.bytes(), "not finite or beyond 1e+18");
    }
  }
}

TEST(Crafted, RunsThatDisagreeWithTheCounts) {
  const auto expect_runs_refused = [](auto change, const char* reason) {
    auto parts = nice();
    change(parts.element<RunRecord>(SectionType::runs, 1));
    expect_refused(parts.bytes(), reason);
  };
  expect_runs_refused([](RunRecord& r) { r.count = 2; }, "disagree");
  expect_runs_refused([](RunRecord& r) { r.count = 0; }, "disagree");
  expect_runs_refused([](RunRecord& r) { r.count = ~std::uint64_t{0}; }, "more than");
  expect_runs_refused([](RunRecord& r) { r.kind = 1; }, "disagree");
  expect_runs_refused([](RunRecord& r) { r.kind = kShapeKindCount; }, "unknown object type");
  expect_runs_refused([](RunRecord& r) { r.reserved = 1; }, "reserved");
}

TEST(Crafted, ShapesOfPicturesThatAreNone) {
  Scene scene = *make_named_scene("nice");
  scene.cameras.resize(2);
  const auto changed = [&](const std::function<void(test::FileParts&)>& change) {
    test::FileParts parts(test::scene_bytes(scene, {{{640, 480}}, {1.5, 0}}));
    change(parts);
    return parts.bytes();
  };
  EXPECT_TRUE(verify(test::AlignedBytes(changed([](auto&) {})).bytes()));
  for (const std::uint32_t side : {0u, 0x100001u, 0x80000000u, 0xffffffffu}) {
    expect_refused(changed([&](auto& parts) {
                     parts.template element<FilmRecord>(SectionType::film).height = side;
                   }),
                   "a film with a side");
  }
  for (const double aspect : {-1.0, kNan, kInf, -kInf}) {
    expect_refused(changed([&](auto& parts) {
                     parts.template element<double>(SectionType::camera_aspects, 1) = aspect;
                   }),
                   "the shape of a camera's picture");
  }
  const auto resize = [](test::FileParts& parts, SectionType type, std::size_t count) {
    auto& section = parts.section(type);
    section.bytes.resize(count * 8, std::byte{1});
    section.entry.count = count;
    section.entry.size = count * 8;
  };
  expect_refused(changed([&](auto& parts) { resize(parts, SectionType::film, 2); }),
                 "more than one film");
  for (const std::size_t count : {1u, 3u}) {
    expect_refused(changed([&](auto& parts) { resize(parts, SectionType::camera_aspects, count); }),
                   "differ in number");
  }
}

}  // namespace
}  // namespace dapple
