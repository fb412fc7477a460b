// Surfaces that the tests of reflectance go through.
#pragma once

#include <string>
#include <vector>

#include "math/fast_functions.h"
#include "shading/bsdf_builder.h"
#include "shading/colour.h"
#include "shading/fresnel.h"

namespace dapple::test {

struct SurfaceCase {
  std::string name;
  LayeredPoint point;  // white, so that it gives back all light
  bool from_outside = true;
  double energy_tolerance = 0.01;
  double grazing_tolerance = 0.01;  // of the same, at a cosine below 0.1
  bool is_narrow = false;           // the density has peaks between the points of a grid
};

inline LayeredPoint white_point(float roughness) {
  LayeredPoint point;
  point.base_colour = {1, 1, 1};
  point.roughness = roughness;
  point.normal = point.clearcoat_normal = {0, 0, 1};
  point.diffuse_transmission_colour = {1, 1, 1};
  return point;
}

// Each lobe by itself and composed with others.
inline std::vector<SurfaceCase> surface_cases(float roughness) {
  std::vector<SurfaceCase> cases;
  const auto add = [&](const char* name, auto change, bool outside = true) {
    SurfaceCase c{name, white_point(roughness), outside};
    change(c.point);
    cases.push_back(c);
  };
  add("dielectric", [](LayeredPoint&) {});
  add("metal", [](LayeredPoint& p) { p.metallic = 1; });
  add("half metal", [](LayeredPoint& p) { p.metallic = 0.5f; });
  add("coat", [](LayeredPoint& p) { p.clearcoat = 1, p.clearcoat_roughness = p.roughness; });
  add("coated metal",
      [](LayeredPoint& p) { p.metallic = 1, p.clearcoat = 0.7f, p.clearcoat_roughness = 0.3f; });
  add("sheen", [](LayeredPoint& p) {
    p.sheen_colour = {1, 1, 1}, p.sheen_roughness = p.roughness;
  });
  add("thin glass", [](LayeredPoint& p) { p.transmission = 1; });
  const auto glass = [](LayeredPoint& p) { p.transmission = 1, p.thin = false; };
  add("glass from outside", glass);
  add("glass from inside", glass, false);
  add("dense glass from outside",
      [&](LayeredPoint& p) { glass(p), p.ior = 2.4f, p.dielectric_f0 = grey(f0_of_ior(p.ior)); });
  add("half glass", [&](LayeredPoint& p) { glass(p), p.transmission = 0.5f; });
  // Near an index of 1 light hardly leaves its way: a lobe too narrow to be integrated on a grid.
  for (const float ior : {1.005f, 1.02f, 1.1f}) {
    const auto watery = [&, ior](LayeredPoint& p) {
      glass(p), p.ior = ior, p.dielectric_f0 = grey(f0_of_ior(ior));
    };
    for (const bool outside : {true, false}) {
      add("watery glass", watery, outside);
      cases.back().energy_tolerance = cases.back().grazing_tolerance = 0.025;
      cases.back().is_narrow = true;
    }
  }
  const auto brushed = [](float strength, float turns) {
    return [=](LayeredPoint& p) {
      const SinCos<float> along = sin_cos_turns(turns);
      p.anisotropy = strength, p.anisotropy_direction = {along.cos, along.sin};
    };
  };
  // Tables of two roughnesses and an azimuth are coarse, worst at grazing angles.
  const auto add_brushed = [&](const char* name, auto change, double tolerance, double grazing) {
    add(name, change);
    cases.back().energy_tolerance = tolerance;
    cases.back().grazing_tolerance = grazing;
    cases.back().is_narrow = roughness < 0.3f;
  };
  for (const float strength : {0.4f, 1.0f}) {
    for (const float turns : {0.1f, 0.35f}) {  // along the view, across
      const auto brush = brushed(strength, turns);
      const auto metal = [&](LayeredPoint& p) { brush(p), p.metallic = 1; };
      add_brushed("brushed metal", metal, 0.02, 0.06);
      add_brushed("brushed dielectric", brush, 0.02, 0.06);
    }
  }
  const auto brushed_glass = [&](LayeredPoint& p) { brushed(0.4f, 0.2f)(p), glass(p); };
  add_brushed("brushed glass", brushed_glass, 0.1, 0.1);
  add("leaf", [](LayeredPoint& p) { p.diffuse_transmission = 0.6f; });
  add("everything", [&](LayeredPoint& p) {
    glass(p);
    p.transmission = 0.4f, p.metallic = 0.3f, p.diffuse_transmission = 0.5f;
    p.clearcoat = 0.5f, p.clearcoat_roughness = 0.2f;
    p.sheen_colour = {0.5f, 0.5f, 0.5f}, p.sheen_roughness = 0.5f;
  });
  return cases;
}

inline Vec3f direction_at(float cosine, float turns) {
  const float sine = std::sqrt(1.0f - cosine * cosine);
  const SinCos<float> around = sin_cos_turns(turns);
  return {sine * around.cos, sine * around.sin, cosine};
}

// Seen from above, which a point from inside takes for the inner side.
inline Bsdf bsdf_of(const SurfaceCase& surface, const Vec3f& wo) {
  SurfaceInteraction at;
  LayeredPoint point = surface.point;
  at.from_outside = surface.from_outside;
  if (!surface.from_outside) {
    at.geometric_normal = at.shading_normal = {0, 0, -1};
    point.normal = -point.normal;
    point.clearcoat_normal = -point.clearcoat_normal;
  }
  return BsdfBuilder(at, wo).layered(point, {});
}

}  // namespace dapple::test
