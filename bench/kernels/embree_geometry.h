// Shapes in Embree's buffers.
#pragma once

#include <embree3/rtcore.h>

#include <array>

#include "scene/scene_view.h"

namespace dapple::bench {

// Ids that Embree gives back with a hit. Quads are the rectangles in the order of their ids.
inline constexpr unsigned kSphereGeometry = 0;
inline constexpr unsigned kQuadGeometry = 1;
inline constexpr unsigned kTriangleGeometry = 2;
// The id of the first primitive of each of these.
using FirstIds = std::array<PrimId, 3>;

void attach_spheres(RTCDevice device, RTCScene scene, const SceneView& view,
                    RTCBuildQuality quality);
void attach_rectangles(RTCDevice device, RTCScene scene, const SceneView& view,
                       RTCBuildQuality quality);
// Those that stand in the world.
void attach_triangles(RTCDevice device, RTCScene scene, const SceneView& view,
                      RTCBuildQuality quality);

}  // namespace dapple::bench
