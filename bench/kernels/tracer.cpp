#include "kernels/tracer.h"

namespace dapple::bench {

std::vector<Found> trace_once(const Contender& contender, std::span<const Ray> rays, Query query) {
  const auto tracers = contender.tracers(rays, query);
  tracers.front()->reset();
  tracers.front()->trace();
  return tracers.front()->found();
}

}  // namespace dapple::bench
