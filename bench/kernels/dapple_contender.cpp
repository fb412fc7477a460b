#include "kernels/dapple_contender.h"

#include "kernels/pieces.h"

namespace dapple::bench {
namespace {

class ClosestTracer final : public Tracer {
 public:
  ClosestTracer(const Accel& accel, std::span<const Ray> rays) : accel_(accel), rays_(rays) {}

  std::string name() const override { return "dapple"; }
  void reset() override { hits_.assign(rays_.size(), Hit{}); }
  void trace() override {
    for_each_piece(rays_.size(), [&](std::size_t begin, std::size_t end) {
      accel_.intersect(rays_.subspan(begin, end - begin),
                       std::span(hits_).subspan(begin, end - begin));
    });
  }
  std::vector<Found> found() const override {
    std::vector<Found> result;
    result.reserve(hits_.size());
    for (const Hit& hit : hits_) result.push_back({hit.t, hit.prim});
    return result;
  }

 private:
  const Accel& accel_;
  std::span<const Ray> rays_;
  std::vector<Hit> hits_;
};

class AnyTracer final : public Tracer {
 public:
  AnyTracer(const Accel& accel, std::span<const Ray> rays) : accel_(accel), rays_(rays) {}

  std::string name() const override { return "dapple"; }
  void reset() override { occluded_.assign(rays_.size(), 0); }
  void trace() override {
    for_each_piece(rays_.size(), [&](std::size_t begin, std::size_t end) {
      accel_.occluded(rays_.subspan(begin, end - begin),
                      std::span(occluded_).subspan(begin, end - begin));
    });
  }
  std::vector<Found> found() const override {
    std::vector<Found> result;
    result.reserve(occluded_.size());
    for (const std::uint8_t o : occluded_) result.push_back({0.0f, o != 0 ? PrimId{0} : kNoPrim});
    return result;
  }

 private:
  const Accel& accel_;
  std::span<const Ray> rays_;
  std::vector<std::uint8_t> occluded_;
};

}  // namespace

std::vector<std::unique_ptr<Tracer>> DappleContender::tracers(std::span<const Ray> rays,
                                                              Query query) const {
  std::vector<std::unique_ptr<Tracer>> result;
  if (query == Query::closest) {
    result.push_back(std::make_unique<ClosestTracer>(*accel_, rays));
  } else {
    result.push_back(std::make_unique<AnyTracer>(*accel_, rays));
  }
  return result;
}

}  // namespace dapple::bench
