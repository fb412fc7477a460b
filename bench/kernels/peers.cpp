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

Expected<Contenders> make_contenders(const ContenderChoice& choice) {
  const auto kind = parse_accel_kind(choice.accel);
  if (!kind) return tl::unexpected(kind.error());
  const auto quality = parse_bvh_quality(choice.quality);
  if (!quality) return tl::unexpected(quality.error());
  Contenders contenders;
  if (choice.only.empty() || choice.only == "dapple") {
    const LeafForm form = choice.compact ? LeafForm::compact : LeafForm::whole;
    contenders.push_back(std::make_unique<DappleContender>(*kind, *quality, form));
  }
#ifdef DAPPLE_BENCH_EMBREE
  const auto embree_quality = parse_quality(choice.embree_quality);
  if (!embree_quality) return tl::unexpected(embree_quality.error());
  if (choice.only.empty() || choice.only == "embree") {
    contenders.push_back(std::make_unique<EmbreeContender>(*embree_quality, choice.compact));
  }
#endif
  if (contenders.empty()) return fail(Errc::usage, choice.only, "no such contender in this build");
  return contenders;
}

}  // namespace dapple::bench
