#include "kernels/peers.h"

#include "kernels/dapple_contender.h"
#ifdef DAPPLE_BENCH_EMBREE
#include "kernels/embree_contender.h"
#endif

namespace dapple::bench {
namespace {

#ifdef DAPPLE_BENCH_EMBREE
Expected<RTCBuildQuality> parse_quality(const std::string& name) {
  if (name == "low") return RTC_BUILD_QUALITY_LOW;
  if (name == "medium") return RTC_BUILD_QUALITY_MEDIUM;
  if (name == "high") return RTC_BUILD_QUALITY_HIGH;
  return fail(Errc::usage, name, "build qualities are low, medium and high");
}
#endif

}  // namespace

Expected<Contenders> make_contenders(const std::string& accel, const std::string& only,
                                     [[maybe_unused]] const std::string& quality, bool compact) {
  const auto kind = parse_accel_kind(accel);
  if (!kind) return tl::unexpected(kind.error());
  Contenders contenders;
  if (only.empty() || only == "dapple") {
    contenders.push_back(std::make_unique<DappleContender>(*kind, compact));
  }
#ifdef DAPPLE_BENCH_EMBREE
  const auto embree_quality = parse_quality(quality);
  if (!embree_quality) return tl::unexpected(embree_quality.error());
  if (only.empty() || only == "embree") {
    contenders.push_back(std::make_unique<EmbreeContender>(*embree_quality, compact));
  }
#endif
  if (contenders.empty()) return fail(Errc::usage, only, "no such contender in this build");
  return contenders;
}

}  // namespace dapple::bench
