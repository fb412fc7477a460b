// One mesh through every simple format gives the same triangles; a file cut anywhere gives an error
// or fewer triangles, never others.
#include <gtest/gtest.h>

#include <algorithm>

#include "import/obj/geometry.h"
#include "import/obj/mesh.h"
#include "import/ply/model.h"
#include "import/stl/reader.h"
#include "tests/import/mesh_texts.h"

namespace dapple {
namespace {

using Read = Expected<MeshData> (*)(const std::string& bytes);

Expected<MeshData> through_obj(const std::string& text) {
  return obj::read_geometry(text, "t.obj").map(obj::build_mesh);
}
Expected<MeshData> through_ply(const std::string& text) {
  return ply::read(as_bytes(text), "t.ply").map([](const ply::Model& m) { return m.mesh; });
}
Expected<MeshData> through_stl(const std::string& text) {
  return stl::read(as_bytes(text), "t.stl").map([](const stl::Model& m) { return m.mesh; });
}

struct Format {
  const char* name;
  std::string (*write)(const MeshData&);
  Read read;
};

const Format kFormats[] = {
    {"Obj", as_obj, through_obj},
    {"PlyAscii", [](const MeshData& m) { return as_ply(m, ply::Format::ascii); }, through_ply},
    {"PlyLittle", [](const MeshData& m) { return as_ply(m, ply::Format::little_endian); },
     through_ply},
    {"PlyBig", [](const MeshData& m) { return as_ply(m, ply::Format::big_endian); }, through_ply},
    {"StlText", as_stl_text, through_stl},
    {"StlBinary", as_stl_binary, through_stl},
};

class SameMesh : public testing::TestWithParam<Format> {};
INSTANTIATE_TEST_SUITE_P(, SameMesh, testing::ValuesIn(kFormats),
                         [](const auto& test) { return test.param.name; });

TEST_P(SameMesh, ComesOutAsItWentIn) {
  const MeshData mesh = bumpy_torus(12);
  const auto read = GetParam().read(GetParam().write(mesh));
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(corner_positions(*read), corner_positions(mesh));
  EXPECT_EQ(read->vertices.positions.size(), mesh.vertices.positions.size());
}

TEST_P(SameMesh, ReadsAnyLineEnd) {
  const MeshData mesh = bumpy_torus(4);
  std::string text = GetParam().write(mesh);

  const bool is_text = std::ranges::all_of(text, [](char c) { return c == '\n' || c >= ' '; });
  if (!is_text) return;  // a binary file has no lines
  for (std::size_t i = text.find('\n'); i != text.npos; i = text.find('\n', i + 2)) {
    text.insert(i, 1, '\r');
  }
  const auto read = GetParam().read(text);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(corner_positions(*read), corner_positions(mesh));
}

TEST_P(SameMesh, CutAnywhereGivesNoOtherTriangles) {
  const MeshData mesh = bumpy_torus(4);
  const std::string whole = GetParam().write(mesh);
  const auto corners = corner_positions(mesh);
  std::size_t errors = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto read = GetParam().read(whole.substr(0, size));
    if (!read) {
      EXPECT_FALSE(read.error().place.empty());
      ++errors;
      continue;
    }
    const auto cut = corner_positions(*read);
    // A last number may have lost digits; the triangles before it are whole.
    const std::size_t sure = cut.empty() ? 0 : cut.size() - 1;
    ASSERT_LE(cut.size(), corners.size());
    EXPECT_TRUE(
        std::equal(cut.begin(), cut.begin() + static_cast<std::ptrdiff_t>(sure), corners.begin()))
        << size;
  }
  EXPECT_GT(errors, 0u);
}

}  // namespace
}  // namespace dapple
