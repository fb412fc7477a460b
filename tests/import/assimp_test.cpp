#include <fmt/format.h>
#include <gtest/gtest.h>

#include "import/registry.h"
#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

// A triangle with corners at the origin, at x = 1 and at z = 2, shown by as many nodes as there are
// places; z is up.
std::string collada(const std::vector<std::string>& places) {
  std::string nodes;
  for (const std::string& place : places) {
    nodes += fmt::format(
        "<node id='n{0}' name='n{0}'><translate>{1}</translate><instance_geometry url='#g'>"
        "<bind_material><technique_common><instance_material symbol='m' target='#m'/>"
        "</technique_common></bind_material></instance_geometry></node>",
        nodes.size(), place);
  }
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
         "version='1.4.1'><asset><up_axis>Z_UP</up_axis></asset>"
         "<library_effects><effect id='e'><profile_COMMON><technique sid='c'><lambert><diffuse>"
         "<color>0.25 0.5 0.75 1</color></diffuse></lambert></technique></profile_COMMON></effect>"
         "</library_effects><library_materials><material id='m'><instance_effect url='#e'/>"
         "</material></library_materials>"
         "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='pa' count='9'>"
         "0 0 0 1 0 0 0 0 2</float_array><technique_common><accessor source='#pa' count='3' "
         "stride='3'><param name='X' type='float'/><param name='Y' type='float'/><param name='Z' "
         "type='float'/></accessor></technique_common></source><vertices id='v'><input "
         "semantic='POSITION' source='#p'/></vertices><triangles count='1' material='m'><input "
         "semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles></mesh></geometry>"
         "</library_geometries><library_visual_scenes><visual_scene id='s'>" +
         nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>"
         "</COLLADA>";
}

class AssimpFile : public testing::Test {
 protected:
  Expected<ImportResult> import(const std::string& name, const std::string& text) {
    put_file(folder_ / name, text);
    return import_scene(folder_ / name, {});
  }
  TemporaryFolder folder_;
};

TEST_F(AssimpFile, ColladaStandsUprightInItsColours) {
  const auto result = import("t.dae", collada({"0 0 5"}));
  ASSERT_TRUE(result) << to_string(result.error());
  const Scene& scene = result->scene;
  ASSERT_EQ(scene.triangles.size(), 1u);
  const Vec3f top = scene.vertices.positions[scene.triangles[0].vertices[2]];
  EXPECT_NEAR(top.y, 7, 1e-6);
  EXPECT_NEAR(top.z, 0, 1e-6);
  const auto& used = scene.materials[index_of(scene.triangle_materials[0])];
  const auto& material = scene.layered_materials[std::get<Layered>(used).index];
  EXPECT_EQ(material.base_colour, Vec3f(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(scene.environment.kind, EnvironmentKind::studio);
}

TEST_F(AssimpFile, AMeshThatIsShownTwiceIsStoredOnce) {
  const auto result = import("t.dae", collada({"0 0 0", "4 0 0"}));
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->scene.triangles.size(), 1u);
  EXPECT_EQ(result->scene.prototypes.size(), 1u);
  ASSERT_EQ(result->scene.instances.size(), 2u);
  EXPECT_EQ(result->scene.instances[1].to_world.rows[0][3], 4);
}

TEST_F(AssimpFile, OffFilesHaveTheirTriangles) {
  const auto result = import("t.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->scene.triangles.size(), 2u);
}

TEST_F(AssimpFile, DamageIsAnErrorWithTheFilesName) {
  for (const char* name : {"t.fbx", "t.dae", "t.3ds"}) {
    for (const std::string& text : {std::string(), std::string("nothing that is known")}) {
      const auto result = import(name, text);
      ASSERT_FALSE(result);
      EXPECT_EQ(result.error().place, folder_ / name);
      EXPECT_EQ(result.error().code, Errc::bad_data);
    }
  }
}

}  // namespace
}  // namespace dapple
