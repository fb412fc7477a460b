// The part of PathVertices that waits for reflectances to be computed many at once.
#include "render/lit_scene.h"
#include "render/path_vertex.h"

namespace dapple {
namespace {

void put(const Vec3f& v, BsdfChunk::Vectors& arrays, std::size_t i) {
  arrays[0][i] = v.x, arrays[1][i] = v.y, arrays[2][i] = v.z;
}
Vec3f vector_at(const BsdfChunk::Vectors& arrays, std::size_t i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}

void put(const LayeredPoint& point, BsdfChunk& c, std::size_t i) {
  put(point.base_colour, c.base_colour, i);
  put(point.dielectric_f0, c.dielectric_f0, i);
  put(point.diffuse_transmission_colour, c.diffuse_transmission_colour, i);
  put(point.sheen_colour, c.sheen_colour, i);
  put(point.normal, c.normal, i);
  put(point.clearcoat_normal, c.clearcoat_normal, i);
  c.metallic[i] = point.metallic;
  c.roughness[i] = point.roughness;
  c.dielectric_f90[i] = point.dielectric_f90;
  c.ior[i] = point.ior;
  c.transmission[i] = point.transmission;
  c.thin[i] = point.thin ? 1.0f : 0.0f;
  c.diffuse_transmission[i] = point.diffuse_transmission;
  c.clearcoat[i] = point.clearcoat;
  c.clearcoat_roughness[i] = point.clearcoat_roughness;
  c.sheen_roughness[i] = point.sheen_roughness;
  c.anisotropy[i] = point.anisotropy;
  c.anisotropy_x[i] = point.anisotropy_direction.x;
  c.anisotropy_y[i] = point.anisotropy_direction.y;
}

}  // namespace

void PathVertices::postpone(std::uint32_t index, const Surface& surface, const Ray& ray,
                            const VertexDraw& draw, LightPath& path,
                            PendingVertices& pending) const {
  const SurfaceInteraction& at = surface.at;
  const std::size_t i = pending.count++;
  PendingVertex& vertex = pending.vertices[i];
  vertex.path = index;
  vertex.place = place_of(surface);
  vertex.u_survival = draw.choose[3];
  const auto light = sample_light(at.position, at.geometric_normal, draw, path);
  vertex.asks_light = light && light->pdf > 0;
  vertex.light = light.value_or(LightSample{{0, 0, 1}, 0, {}, 0, false});

  BsdfChunk& c = pending.chunk;
  put(lit_.materials().point(surface.material, at), c, i);
  put(at.geometric_normal, c.geometric_normal, i);
  put(at.tangent, c.tangent, i);
  put(-ray.direction, c.wo, i);
  c.bitangent_sign[i] = at.bitangent_sign;
  c.from_outside[i] = at.from_outside ? 1.0f : 0.0f;
  put(vertex.light.wi, c.light_wi, i);
  c.u_lobe[i] = draw.choose[1];
  c.u_x[i] = draw.move[0];
  c.u_y[i] = draw.move[1];
}

bool PathVertices::finish(const PendingVertices& pending, std::size_t i, LightPath& path, Ray& ray,
                          std::vector<ShadowRay>& shadow_rays) const {
  const PendingVertex& vertex = pending.vertices[i];
  const BsdfChunk& c = pending.chunk;
  const std::uint32_t flags = c.flags[i];
  if (vertex.asks_light && (flags & BsdfChunk::kSpecularOnly) == 0) {
    add_shadow_ray(vertex.path, path, vertex.place, vertex.light,
                   {vector_at(c.light_f, i), c.light_pdf[i]}, shadow_rays);
  }
  if ((flags & BsdfChunk::kFound) == 0) return false;
  BsdfSample sample;
  sample.wi = vector_at(c.wi, i);
  sample.weight = vector_at(c.weight, i);
  sample.pdf = c.pdf[i];
  sample.roughness = c.wi_roughness[i];
  sample.specular = (flags & BsdfChunk::kSpecular) != 0;
  sample.transmitted = (flags & BsdfChunk::kTransmitted) != 0;
  return scatter(vertex.place, sample, path, ray) && survives(vertex.u_survival, path);
}

}  // namespace dapple
