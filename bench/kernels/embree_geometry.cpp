#include "kernels/embree_geometry.h"

#include <algorithm>

#include "parallel/parallel.h"

namespace dapple::bench {
namespace {

struct QuadCorners {
  float corner[4][3];
};

QuadCorners corners_of(ShapeKind kind, const Rectangle& r) {
  const RectangleAxes axes = rectangle_axes(kind);
  const double u[4] = {r.u0, r.u1, r.u1, r.u0};
  const double v[4] = {r.v0, r.v0, r.v1, r.v1};
  QuadCorners quad{};
  for (int i = 0; i < 4; ++i) {
    quad.corner[i][axes.u] = static_cast<float>(u[i]);
    quad.corner[i][axes.v] = static_cast<float>(v[i]);
    quad.corner[i][axes.k] = static_cast<float>(r.k);
  }
  return quad;
}

void attach(RTCScene scene, RTCGeometry geometry, unsigned id, RTCBuildQuality quality) {
  rtcSetGeometryBuildQuality(geometry, quality);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

template <class T>
T* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t stride,
              std::size_t count) {
  return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count));
}

}  // namespace

void attach_spheres(RTCDevice device, RTCScene scene, const SceneView& view,
                    RTCBuildQuality quality) {
  constexpr std::size_t kPerTask = 1 << 16;
  const std::size_t count = view.spheres.size();
  if (count == 0) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* numbers = new_buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                                    4 * sizeof(float), count);
  parallel_for_dynamic((count + kPerTask - 1) / kPerTask, [&](std::size_t task) {
    for (std::size_t i = task * kPerTask; i < count && i < (task + 1) * kPerTask; ++i) {
      const Sphere& sphere = view.spheres[i];
      for (int axis = 0; axis < 3; ++axis) {
        numbers[4 * i + static_cast<std::size_t>(axis)] = static_cast<float>(sphere.centre[axis]);
      }
      numbers[4 * i + 3] = static_cast<float>(sphere.radius);
    }
  });
  attach(scene, geometry, kSphereGeometry, quality);
}

void attach_rectangles(RTCDevice device, RTCScene scene, const SceneView& view,
                       RTCBuildQuality quality) {
  std::size_t count = 0;
  for (const auto& of_kind : view.rectangles) count += of_kind.size();
  if (count == 0) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
  auto* quads = new_buffer<QuadCorners>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                        3 * sizeof(float), 4 * count);
  auto* indices = new_buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT4,
                                       4 * sizeof(unsigned), count);
  for (unsigned i = 0; i < 4 * count; ++i) indices[i] = i;
  for (std::size_t k = 0; k < kRectangleKindCount; ++k) {
    for (const Rectangle& rectangle : view.rectangles[k]) {
      *quads++ = corners_of(rectangle_kind(k), rectangle);
    }
  }
  attach(scene, geometry, kQuadGeometry, quality);
}

// Embree reads sixteen bytes at the last vertex, four of which may not be ours: positions are
// copied.
void attach_triangles(RTCDevice device, RTCScene scene, const SceneView& view,
                      RTCBuildQuality quality) {
  const std::size_t count = view.object_count(ShapeKind::triangle);
  if (count == 0) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const auto positions = view.vertices.positions;
  auto* vertices = new_buffer<Vec3f>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                     sizeof(Vec3f), positions.size());
  std::copy(positions.begin(), positions.end(), vertices);
  auto* indices = new_buffer<Triangle>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                       sizeof(Triangle), count);
  std::copy_n(view.triangles.begin(), count, indices);
  attach(scene, geometry, kTriangleGeometry, quality);
}

}  // namespace dapple::bench
