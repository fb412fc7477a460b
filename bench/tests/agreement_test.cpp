#include "kernels/agreement.h"

#include <gtest/gtest.h>

#include "kernels/exact_hit.h"

namespace dapple::bench {
namespace {

// Two unit spheres behind each other on the x axis, and a rectangle behind both.
Scene row_of_shapes() {
  Scene scene;
  const MaterialId grey = scene.add_material(Lambertian{{0.5, 0.5, 0.5}});
  scene.add_sphere({{5, 0, 0}, 1}, grey);
  scene.add_sphere({{10, 0, 0}, 1}, grey);
  scene.add_rectangle(ShapeKind::yz_rectangle, {-2, 2, -2, 2, 20}, grey);
  return scene;
}

Ray along_x(float y, float t_max = 1e30f) { return {{0, y, 0}, 1e-3f, {1, 0, 0}, t_max}; }

TEST(ExactHit, AgreesWithGeometry) {
  const Scene scene = row_of_shapes();
  EXPECT_EQ(exact_hit(scene, along_x(0), 0).verdict, Verdict::hit);
  EXPECT_DOUBLE_EQ(exact_hit(scene, along_x(0), 0).t, 4);
  EXPECT_DOUBLE_EQ(exact_hit(scene, along_x(0), 1).t, 9);
  EXPECT_DOUBLE_EQ(exact_hit(scene, along_x(0), 2).t, 20);
  EXPECT_EQ(exact_hit(scene, along_x(1.5f), 0).verdict, Verdict::miss);
  EXPECT_EQ(exact_hit(scene, along_x(1.5f), 2).verdict, Verdict::hit);
  EXPECT_EQ(exact_hit(scene, along_x(2.5f), 2).verdict, Verdict::miss);
  EXPECT_EQ(exact_hit(scene, along_x(0, 3.0f), 0).verdict, Verdict::miss);
}

TEST(ExactHit, FromInsideTheFarSideIsHit) {
  const ExactHit hit = exact_hit(row_of_shapes(), {{5, 0, 0}, 1e-3f, {1, 0, 0}, 100}, 0);
  EXPECT_EQ(hit.verdict, Verdict::hit);
  EXPECT_DOUBLE_EQ(hit.t, 1);
}

TEST(ExactHit, SilhouettesEdgesAndEndsAreBorderline) {
  const Scene scene = row_of_shapes();
  EXPECT_EQ(exact_hit(scene, along_x(1.0f), 0).verdict, Verdict::borderline);
  EXPECT_EQ(exact_hit(scene, along_x(2.0f), 2).verdict, Verdict::borderline);
  EXPECT_EQ(exact_hit(scene, along_x(0, 4.0f), 0).verdict, Verdict::borderline);
  // What is only nearly there is not.
  EXPECT_EQ(exact_hit(scene, along_x(0.99f), 0).verdict, Verdict::hit);
  EXPECT_EQ(exact_hit(scene, along_x(1.01f), 0).verdict, Verdict::miss);
}

class Judgement : public testing::Test {
 protected:
  Agreement compare(const Ray& ray, Found a, Found b) const {
    return compare_closest(scene_, std::span(&ray, 1), std::span(&a, 1), std::span(&b, 1));
  }
  Scene scene_ = row_of_shapes();
};

TEST_F(Judgement, BlamesWhoeverMissesTheNearerShape) {
  EXPECT_EQ(compare(along_x(0), {4, 0}, {9, 1}).b_wrong, 1u);
  EXPECT_EQ(compare(along_x(0), {9, 1}, {4, 0}).a_wrong, 1u);
  EXPECT_EQ(compare(along_x(0), {4, 0}, {}).b_wrong, 1u);
}

TEST_F(Judgement, BlamesWhoeverFindsWhatIsNotThere) {
  EXPECT_EQ(compare(along_x(1.5f), {4, 0}, {20, 2}).a_wrong, 1u);
  EXPECT_EQ(compare(along_x(1.5f), {}, {20, 2}).a_wrong, 1u);
  EXPECT_EQ(compare(along_x(2.5f), {}, {4, 0}).b_wrong, 1u);
}

TEST_F(Judgement, BlamesAWrongDistance) {
  EXPECT_EQ(compare(along_x(0), {4, 0}, {4.01f, 0}).b_wrong, 1u);
  EXPECT_EQ(compare(along_x(0), {4, 0}, {4.000001f, 0}).same, 1u);
}

TEST_F(Judgement, ForgivesGrazingRays) {
  EXPECT_EQ(compare(along_x(1.0f), {5, 0}, {20, 2}).borderline, 1u);
}

}  // namespace
}  // namespace dapple::bench
