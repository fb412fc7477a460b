// The vector kernels that describe and shade surfaces against the scalar definitions that they
// follow: the same numbers, on every instruction set.
#include <gtest/gtest.h>

#include <memory>

#include "render/lit_scene.h"
#include "render/prepared_scene.h"
#include "shading/bsdf_builder.h"
#include "tests/render/light_kernel_cases.h"
#include "tests/render/lit_scenes.h"

namespace dapple::test {
namespace {

void put(const Vec3f& v, BsdfChunk::Vectors& arrays, std::size_t i) {
  for (int axis = 0; axis < 3; ++axis) arrays[axis][i] = v[axis];
}

// A point with some of the layers, and extreme values among the usual.
LayeredPoint random_point(Chance& chance, const Vec3f& normal) {
  const auto parameter = [&] {
    return chance.once_in(4) ? 0.0f : chance.once_in(4) ? 1.0f : chance.unit();
  };
  const auto bent = [&] {
    return chance.once_in(2) ? normal : normalize(normal + 0.9f * chance.direction());
  };
  LayeredPoint p;
  p.base_colour = chance.colour();
  p.metallic = parameter(), p.roughness = parameter();
  p.dielectric_f0 = 0.1f * chance.colour();
  p.dielectric_f90 = parameter();
  p.ior = chance.once_in(8) ? 1.0f : chance.between(1, 2.5f);
  p.transmission = chance.once_in(2) ? 0.0f : parameter();
  p.thin = chance.once_in(2);
  if (chance.once_in(3)) {
    p.diffuse_transmission = parameter(), p.diffuse_transmission_colour = chance.colour();
  }
  if (chance.once_in(3)) {
    p.clearcoat = parameter(), p.clearcoat_roughness = parameter();
  }
  if (chance.once_in(3)) {
    p.sheen_colour = chance.colour(), p.sheen_roughness = parameter();
  }
  if (chance.once_in(3)) {
    p.anisotropy = parameter();
    const SinCos<float> turned = sin_cos_turns(chance.unit());
    p.anisotropy_direction = {turned.cos, turned.sin};
  }
  p.normal = bent(), p.clearcoat_normal = bent();
  return p;
}

struct BsdfCase {
  SurfaceInteraction at;
  Vec3f wo, light;
  LayeredPoint point;
};

BsdfCase random_case(Chance& chance) {
  BsdfCase c;
  const Vec3f n = chance.direction();
  c.at.geometric_normal = c.at.shading_normal = n;
  c.at.tangent = chance.once_in(10) ? n : chance.direction();
  c.at.bitangent_sign = chance.once_in(2) ? -1.0f : 1.0f;
  c.wo = chance.direction();
  c.light = chance.direction();
  c.at.from_outside = dot(c.wo, n) > 0;
  c.point = random_point(chance, n);
  return c;
}

void put(const BsdfCase& source, BsdfChunk& c, std::size_t i) {
  const LayeredPoint& p = source.point;
  put(source.at.geometric_normal, c.geometric_normal, i);
  put(source.at.tangent, c.tangent, i);
  put(source.wo, c.wo, i);
  put(source.light, c.light_wi, i);
  c.bitangent_sign[i] = source.at.bitangent_sign;
  c.from_outside[i] = source.at.from_outside ? 1.0f : 0.0f;
  put(p.base_colour, c.base_colour, i);
  put(p.dielectric_f0, c.dielectric_f0, i);
  put(p.diffuse_transmission_colour, c.diffuse_transmission_colour, i);
  put(p.sheen_colour, c.sheen_colour, i);
  put(p.normal, c.normal, i);
  put(p.clearcoat_normal, c.clearcoat_normal, i);
  c.metallic[i] = p.metallic, c.roughness[i] = p.roughness;
  c.dielectric_f90[i] = p.dielectric_f90, c.ior[i] = p.ior;
  c.transmission[i] = p.transmission, c.thin[i] = p.thin ? 1.0f : 0.0f;
  c.diffuse_transmission[i] = p.diffuse_transmission;
  c.clearcoat[i] = p.clearcoat, c.clearcoat_roughness[i] = p.clearcoat_roughness;
  c.sheen_roughness[i] = p.sheen_roughness, c.anisotropy[i] = p.anisotropy;
  c.anisotropy_x[i] = p.anisotropy_direction.x, c.anisotropy_y[i] = p.anisotropy_direction.y;
}

void expect_same(const BsdfCase& source, const BsdfChunk& c, std::size_t i) {
  const Bsdf bsdf = BsdfBuilder(source.at, source.wo).layered(source.point, {});
  const BsdfValue lit = bsdf.evaluate(source.light);
  ASSERT_EQ(vector_at(c.light_f, i), lit.f) << i;
  ASSERT_EQ(c.light_pdf[i], lit.pdf) << i;
  ASSERT_EQ((c.flags[i] & BsdfChunk::kSpecularOnly) != 0, bsdf.is_specular_only()) << i;
  const auto next = bsdf.sample(c.u_lobe[i], {c.u_x[i], c.u_y[i]});
  ASSERT_EQ((c.flags[i] & BsdfChunk::kFound) != 0, next.has_value()) << i;
  if (!next) return;
  ASSERT_EQ(vector_at(c.wi, i), next->wi) << i;
  ASSERT_EQ(vector_at(c.weight, i), next->weight) << i;
  ASSERT_EQ(c.pdf[i], next->pdf) << i;
  ASSERT_EQ(c.wi_roughness[i], next->roughness) << i;
  ASSERT_EQ((c.flags[i] & BsdfChunk::kSpecular) != 0, next->specular) << i;
  ASSERT_EQ((c.flags[i] & BsdfChunk::kTransmitted) != 0, next->transmitted) << i;
}

TEST(SurfaceKernels, ShadeAsTheScalarBsdf) {
  Chance chance(4);
  const auto chunk = std::make_unique<BsdfChunk>();
  for (int round = 0; round < 40; ++round) {
    const std::size_t count = kCounts[round % 3];
    std::vector<BsdfCase> cases;
    for (std::size_t i = 0; i < count; ++i) {
      cases.push_back(random_case(chance));
      put(cases[i], *chunk, i);
      chunk->u_lobe[i] = chance.unit(), chunk->u_x[i] = chance.unit();
      chunk->u_y[i] = chance.unit();
    }
    on_every_isa([&](const LightKernels& kernels) {
      kernels.shade(albedo_pairs(), count, *chunk);
      for (std::size_t i = 0; i < count; ++i) expect_same(cases[i], *chunk, i);
    });
  }
}

// Triangles around the origin with whichever attributes.
Scene random_mesh(Chance& chance, bool normals, bool tangents, int uv_sets, bool colours) {
  Scene scene = empty_lit_scene(10);
  LayeredMaterial material;
  const MaterialId materials[] = {add_layered(scene, material), add_diffuse(scene, 0.5f)};
  Vertices& v = scene.vertices;
  for (int i = 0; i < 300; ++i) {
    v.positions.push_back(10.0f * chance.direction() + chance.direction());
    if (normals) v.normals.push_back(chance.once_in(9) ? Vec3f() : chance.direction());
    const Vec3f t = chance.once_in(9) ? Vec3f() : chance.direction();
    if (tangents) v.tangents.push_back({t.x, t.y, t.z, chance.once_in(2) ? 1.0f : -1.0f});
    for (int set = 0; set < uv_sets; ++set) {
      v.uvs[static_cast<std::size_t>(set)].push_back(
          chance.once_in(9) ? Vec2f() : Vec2f{chance.between(-3, 3), chance.unit()});
    }
    if (colours) v.colours.push_back({chance.unit(), chance.unit(), chance.unit(), 1});
  }
  for (int i = 0; i < 200; ++i) {
    scene.add_triangle({{chance.below(300), chance.below(300), chance.below(300)}},
                       materials[chance.below(2)]);
  }
  return scene;
}

void expect_same(const Surface& a, const Surface& b) {
  ASSERT_EQ(a.material, b.material);
  ASSERT_EQ(a.error, b.error);
  ASSERT_EQ(a.emitter.index, b.emitter.index);
  ASSERT_EQ(a.emitter.kind, b.emitter.kind);
  ASSERT_EQ(a.emitter.instance, b.emitter.instance);
  ASSERT_EQ(a.at.position, b.at.position);
  ASSERT_EQ(a.at.geometric_normal, b.at.geometric_normal);
  ASSERT_EQ(a.at.shading_normal, b.at.shading_normal);
  ASSERT_EQ(a.at.tangent, b.at.tangent);
  ASSERT_EQ(a.at.bitangent_sign, b.at.bitangent_sign);
  ASSERT_EQ(a.at.uvs, b.at.uvs);
  ASSERT_EQ(a.at.colour, b.at.colour);
  ASSERT_EQ(a.at.uv_per_length, b.at.uv_per_length);
  ASSERT_EQ(a.at.from_outside, b.at.from_outside);
}

TEST(SurfaceKernels, DescribeSurfacesAsTheScalarBuilder) {
  Chance chance(5);
  const auto chunk = std::make_unique<SurfaceChunk>();
  for (int round = 0; round < 12; ++round) {
    const Scene scene =
        random_mesh(chance, round % 2 == 0, round % 3 == 0, round % 4 % 3, round % 5 == 0);
    const auto accel = make_accel(AccelKind::fast, scene, BvhQuality::medium,
                                  round % 4 < 2 ? LeafForm::whole : LeafForm::compact);
    const SurfaceBuilder builder(scene);
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    while (hits.size() < kCounts[round % 3]) {
      const Ray ray{12.0f * chance.direction(), 0, chance.direction()};
      const Hit hit = accel->intersect(ray);
      if (!hit.found()) continue;
      ASSERT_TRUE(builder.fits_chunk(hit));
      builder.put(ray, hit, hits.size(), *chunk);
      rays.push_back(ray);
      hits.push_back(hit);
    }
    on_every_isa([&](const LightKernels& kernels) {
      kernels.describe(builder.mesh(*accel), hits.size(), *chunk);
      for (std::size_t i = 0; i < hits.size(); ++i) {
        expect_same(builder.from_chunk(*chunk, i, rays[i], 0.25f),
                    builder.build(*accel, rays[i], hits[i], 0.25f));
      }
    });
  }
}

}  // namespace
}  // namespace dapple::test
