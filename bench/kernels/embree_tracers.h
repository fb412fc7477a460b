// Embree's ways of tracing rays: one by one, as a stream, in packets of 8 and 16; the latter with
// and without the promise that the rays are coherent.
#pragma once

#include <embree3/rtcore.h>

#include "kernels/embree_geometry.h"
#include "kernels/tracer.h"

namespace dapple::bench {

// `first_quad_id` is the primitive id of Embree's quad 0. The rays are copied into Embree's own
// layouts beforehand, so tracing costs it no conversion.
[[nodiscard]] std::vector<std::unique_ptr<Tracer>> make_embree_tracers(RTCScene scene,
                                                                       std::span<const Ray> rays,
                                                                       Query query,
                                                                       const FirstIds& first_ids);

}  // namespace dapple::bench
