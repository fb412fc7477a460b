#include "render/surface_builder.h"

#include <cmath>

#include "math/fast_functions.h"
#include "math/frame.h"

namespace dapple {
namespace {

constexpr std::size_t kMostGathered = std::size_t{1} << 31;
constexpr float kSmallest = 1e-30f;  // of a squared length that still has a direction

Vec3f normalized_or(const Vec3f& v, const Vec3f& fallback) {
  const float squared = dot(v, v);
  return squared > kSmallest ? v / std::sqrt(squared) : fallback;
}

template <class T>
T mixed(const std::array<float, 3>& weights, std::span<const T> values,
        const std::array<std::uint32_t, 3>& corners) {
  return weights[0] * values[corners[0]] + weights[1] * values[corners[1]] +
         weights[2] * values[corners[2]];
}

// An interpolated normal of the object, turned into the world and to the outward side.
void set_normal(const Vec3f& normal, const Transformf* to_world, SurfaceInteraction& at) {
  const Vec3f n = to_world != nullptr ? inverse(*to_world).transposed_vector(normal) : normal;
  at.shading_normal = normalized_or(n, at.geometric_normal);
  if (dot(at.shading_normal, at.geometric_normal) < 0) at.shading_normal = -at.shading_normal;
}

// Direction in which a texture coordinate grows over a triangle, and the root of its area over the
// triangle's.
struct UvFrame {
  Vec3f along_u;
  float sign = 1;
  float per_length = 0;
};

UvFrame uv_frame(const Vec3f& e1, const Vec3f& e2, Vec2f d1, Vec2f d2) {
  const float area = d1.x * d2.y - d1.y * d2.x;
  const float world_area = length(cross(e1, e2));
  UvFrame frame;
  if (area == 0 || !(world_area > 0)) return frame;
  const float sign = area < 0 ? -1.0f : 1.0f;
  frame.along_u = sign * (d2.y * e1 - d1.y * e2);
  // v grows downwards in images, and tangent frames are right-handed with v upwards.
  frame.sign = -sign;
  frame.per_length = std::sqrt(std::fabs(area) / world_area);
  return frame;
}

// Makes the tangent orthogonal to the shading normal; any direction will do where there is none.
void set_tangent(const Vec3f& wish, SurfaceInteraction& at) {
  at.tangent = frame_along(at.shading_normal, wish).tangent;
}

}  // namespace

SurfaceBuilder::SurfaceBuilder(const SceneView& scene)
    : scene_(scene),
      fits_chunks_(scene.vertices.positions.size() < kMostGathered / 4 &&
                   scene.triangles.size() < kMostGathered / 4),
      first_ids_(first_prim_ids(scene)) {}

std::uint32_t SurfaceBuilder::index_of(const Hit& hit) const {
  const auto kind = static_cast<std::size_t>(hit.lane.kind());
  return static_cast<std::uint32_t>(hit.prim - first_ids_[kind]);
}

MaterialId SurfaceBuilder::material_of(const Hit& hit) const {
  return scene_.materials_of(hit.lane.kind())[index_of(hit)];
}

Surface SurfaceBuilder::build(const Accel& accel, const Ray& ray, const Hit& hit,
                              float cone_width) const {
  const SurfacePoint point = accel.locate(ray, hit);
  const std::uint32_t index = index_of(hit);
  const ShapeKind kind = hit.lane.kind();
  Surface surface;
  surface.material = material_of(hit);
  surface.error = point.error;
  surface.emitter.index = index;
  surface.at.position = point.position;
  surface.at.geometric_normal = surface.at.shading_normal = point.outward;
  surface.at.cone_width = cone_width;
  surface.at.from_outside = dot(ray.direction, point.outward) < 0;
  if (kind == ShapeKind::triangle) {
    const Transformf* to_world = nullptr;
    if (hit.lane.in_instance()) {
      const std::size_t instance = hit.lane.instance_index();
      surface.emitter.instance = static_cast<std::uint32_t>(instance);
      to_world = &scene_.instances[instance].to_world;
    }
    describe_triangle(index, point, to_world, surface);
  } else if (kind == ShapeKind::sphere) {
    describe_sphere(index, surface);
  } else if (kind == ShapeKind::cylinder) {
    surface.emitter.kind = EmitterKind::cylinder;
    set_tangent({}, surface.at);
  } else {
    describe_rectangle(kind, index, surface);
  }
  return surface;
}

MeshView SurfaceBuilder::mesh(const Accel& accel) const {
  const auto floats = [](const auto& array) {
    return array.empty() ? nullptr : reinterpret_cast<const float*>(array.data());
  };
  MeshView view;
  view.leaves = accel.leaves();
  view.corners = reinterpret_cast<const std::uint32_t*>(scene_.triangles.data());
  view.materials = reinterpret_cast<const std::uint32_t*>(scene_.triangle_materials.data());
  view.normals = floats(scene_.vertices.normals);
  view.tangents = floats(scene_.vertices.tangents);
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    view.uvs[set] = floats(scene_.vertices.uvs[set]);
  }
  return view;
}

void SurfaceBuilder::put(const Ray& ray, const Hit& hit, std::size_t i, SurfaceChunk& chunk) const {
  for (int axis = 0; axis < 3; ++axis) {
    chunk.origin[axis][i] = ray.origin[axis];
    chunk.direction[axis][i] = ray.direction[axis];
  }
  chunk.lane[i] = static_cast<std::uint32_t>(hit.lane.bits);
  chunk.triangle[i] = index_of(hit);
}

Surface SurfaceBuilder::from_chunk(const SurfaceChunk& c, std::size_t i, const Ray& ray,
                                   float cone_width) const {
  const auto vector = [i](const SurfaceChunk::Vectors& arrays) {
    return Vec3f(arrays[0][i], arrays[1][i], arrays[2][i]);
  };
  Surface surface;
  surface.material = static_cast<MaterialId>(c.material[i]);
  surface.error = c.error[i];
  surface.emitter.index = c.triangle[i];
  surface.emitter.kind = EmitterKind::triangle;
  SurfaceInteraction& at = surface.at;
  at.position = vector(c.position);
  at.geometric_normal = vector(c.outward);
  at.shading_normal = vector(c.shading_normal);
  at.tangent = vector(c.tangent);
  at.bitangent_sign = c.bitangent_sign[i];
  at.cone_width = cone_width;
  at.from_outside = dot(ray.direction, at.geometric_normal) < 0;
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    if (scene_.vertices.uvs[set].empty()) continue;
    at.uvs[set] = {c.u[set][i], c.v[set][i]};
    at.uv_per_length[set] = c.uv_per_length[set][i];
  }
  if (!scene_.vertices.colours.empty()) {
    const Weights weights = {1 - c.weight_1[i] - c.weight_2[i], c.weight_1[i], c.weight_2[i]};
    at.colour = mixed(weights, scene_.vertices.colours, scene_.triangles[c.triangle[i]].vertices);
  }
  return surface;
}

void SurfaceBuilder::describe_triangle(std::uint32_t index, const SurfacePoint& point,
                                       const Transformf* to_world, Surface& surface) const {
  SurfaceInteraction& at = surface.at;
  const VertexView& vertices = scene_.vertices;
  const auto corners = scene_.triangles[index].vertices;
  const Weights weights = {1 - point.u - point.v, point.u, point.v};
  surface.emitter.kind = EmitterKind::triangle;
  if (!vertices.normals.empty())
    set_normal(mixed(weights, vertices.normals, corners), to_world, at);
  if (!vertices.colours.empty()) at.colour = mixed(weights, vertices.colours, corners);
  Vec3f tangent = set_uvs(index, weights, to_world, at);
  if (!vertices.tangents.empty()) {
    const Vec4f given = mixed(weights, vertices.tangents, corners);
    if (dot(given.xyz(), given.xyz()) > kSmallest) {
      tangent = to_world != nullptr ? to_world->vector(given.xyz()) : given.xyz();
      // A mirroring map turns the bitangent around too.
      const bool mirrored = to_world != nullptr && determinant(*to_world) < 0;
      at.bitangent_sign = (given.w < 0) != mirrored ? -1.0f : 1.0f;
    }
  }
  set_tangent(tangent, at);
}

// Texture coordinates; returns the direction in which those of the first set grow to the right.
Vec3f SurfaceBuilder::set_uvs(std::uint32_t index, const Weights& weights,
                              const Transformf* to_world, SurfaceInteraction& at) const {
  const auto corners = scene_.triangles[index].vertices;
  const auto& p = scene_.vertices.positions;
  Vec3f e1 = p[corners[1]] - p[corners[0]], e2 = p[corners[2]] - p[corners[0]];
  if (to_world != nullptr) {
    e1 = to_world->vector(e1);
    e2 = to_world->vector(e2);
  }
  Vec3f along_u;
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    const auto& uv = scene_.vertices.uvs[set];
    if (uv.empty()) continue;
    at.uvs[set] = mixed(weights, uv, corners);
    const UvFrame frame =
        uv_frame(e1, e2, uv[corners[1]] - uv[corners[0]], uv[corners[2]] - uv[corners[0]]);
    at.uv_per_length[set] = frame.per_length;
    if (set > 0) continue;
    along_u = frame.along_u;
    at.bitangent_sign = frame.sign;
  }
  return along_u;
}

// u runs around the y axis, v from the top down, as on a globe.
void SurfaceBuilder::describe_sphere(std::uint32_t index, Surface& surface) const {
  SurfaceInteraction& at = surface.at;
  surface.emitter.kind = EmitterKind::sphere;
  const Vec3f n = at.geometric_normal;
  at.uvs[0] = {fast_atan2(n.z, n.x) * (0.5f * kInvPi) + 0.5f, fast_acos(n.y) * kInvPi};
  at.uvs[1] = at.uvs[0];
  const auto radius = static_cast<float>(std::fabs(scene_.spheres[index].radius));
  // The square root of the unit square over the sphere's area 4 pi r^2.
  at.uv_per_length[0] = at.uv_per_length[1] = radius > 0 ? 0.28209479f / radius : 0.0f;
  at.bitangent_sign = -1;
  set_tangent({-n.z, 0, n.x}, at);
}

void SurfaceBuilder::describe_rectangle(ShapeKind kind, std::uint32_t index,
                                        Surface& surface) const {
  SurfaceInteraction& at = surface.at;
  surface.emitter.kind = static_cast<EmitterKind>(static_cast<std::uint32_t>(EmitterKind::sphere) +
                                                  static_cast<std::uint32_t>(kind));
  const Rectangle& r = scene_.rectangles[rectangle_index(kind)][index];
  const RectangleAxes axes = rectangle_axes(kind);
  const auto width = static_cast<float>(r.u1 - r.u0), height = static_cast<float>(r.v1 - r.v0);
  if (width > 0 && height > 0) {
    const Vec2f uv{(at.position[axes.u] - static_cast<float>(r.u0)) / width,
                   1 - (at.position[axes.v] - static_cast<float>(r.v0)) / height};
    at.uvs[0] = at.uvs[1] = uv;
    at.uv_per_length[0] = at.uv_per_length[1] = 1 / std::sqrt(width * height);
  }
  Vec3f along_u;
  along_u[axes.u] = 1;
  set_tangent(along_u, at);
}

}  // namespace dapple
