#include "kernels/embree_tracers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>

#include "kernels/embree_geometry.h"
#include "kernels/pieces.h"

namespace dapple::bench {
namespace {

enum class Promise { incoherent, coherent };

RTCIntersectContext context_of(Promise promise) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = promise == Promise::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                               : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}

const char* suffix(Promise promise) { return promise == Promise::coherent ? "c" : "i"; }

Found found_of(float t_far, unsigned geometry, unsigned prim, const FirstIds& first_ids) {
  if (geometry == RTC_INVALID_GEOMETRY_ID) return {t_far, kNoPrim};
  return {t_far, first_ids[geometry] + prim};
}

// Embree marks an occluded ray with a negative end.
Found found_of_occluded(float t_far) { return {0.0f, t_far < 0.0f ? PrimId{0} : kNoPrim}; }

// ---- One ray a structure: rtcIntersect1 and rtcIntersect1M ----

RTCRay to_embree(const Ray& ray) {
  return {ray.origin.x,
          ray.origin.y,
          ray.origin.z,
          ray.t_min,
          ray.direction.x,
          ray.direction.y,
          ray.direction.z,
          0.0f,
          ray.t_max,
          ~0u,
          0u,
          0u};
}

// Record is RTCRayHit for closest hits and RTCRay for any hit.
template <class Record>
class RecordTracer : public Tracer {
 public:
  RecordTracer(RTCScene scene, std::span<const Ray> rays, const FirstIds& first_ids)
      : scene_(scene), rays_(rays), first_ids_(first_ids) {}

  void reset() override {
    records_.resize(rays_.size());
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      if constexpr (kClosest) {
        records_[i].ray = to_embree(rays_[i]);
        records_[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
      } else {
        records_[i] = to_embree(rays_[i]);
      }
    }
  }
  std::vector<Found> found() const override {
    std::vector<Found> result;
    result.reserve(records_.size());
    for (const Record& record : records_) {
      if constexpr (kClosest) {
        result.push_back(
            found_of(record.ray.tfar, record.hit.geomID, record.hit.primID, first_ids_));
      } else {
        result.push_back(found_of_occluded(record.tfar));
      }
    }
    return result;
  }

 protected:
  static constexpr bool kClosest = std::is_same_v<Record, RTCRayHit>;

  RTCScene scene_;
  std::span<const Ray> rays_;
  std::vector<Record> records_;
  FirstIds first_ids_;
};

template <class Record>
class SingleTracer final : public RecordTracer<Record> {
 public:
  using RecordTracer<Record>::RecordTracer;
  std::string name() const override { return "Embree 1"; }
  void trace() override {
    for_each_piece(this->records_.size(), [&](std::size_t begin, std::size_t end) {
      RTCIntersectContext context = context_of(Promise::incoherent);
      for (std::size_t i = begin; i < end; ++i) {
        if constexpr (RecordTracer<Record>::kClosest) {
          rtcIntersect1(this->scene_, &context, &this->records_[i]);
        } else {
          rtcOccluded1(this->scene_, &context, &this->records_[i]);
        }
      }
    });
  }
};

template <class Record>
class StreamTracer final : public RecordTracer<Record> {
 public:
  StreamTracer(RTCScene scene, std::span<const Ray> rays, const FirstIds& first_ids,
               Promise promise)
      : RecordTracer<Record>(scene, rays, first_ids), promise_(promise) {}
  std::string name() const override { return fmt::format("Embree 1M {}", suffix(promise_)); }
  void trace() override {
    for_each_piece(this->records_.size(), [&](std::size_t begin, std::size_t end) {
      RTCIntersectContext context = context_of(promise_);
      const auto count = static_cast<unsigned>(end - begin);
      if constexpr (RecordTracer<Record>::kClosest) {
        rtcIntersect1M(this->scene_, &context, &this->records_[begin], count, sizeof(Record));
      } else {
        rtcOccluded1M(this->scene_, &context, &this->records_[begin], count, sizeof(Record));
      }
    });
  }

 private:
  Promise promise_;
};

// ---- Packets: rtcIntersect8 and rtcIntersect16 ----

void trace_packet(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* p) {
  rtcIntersect8(valid, scene, context, p);
}
void trace_packet(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit16* p) {
  rtcIntersect16(valid, scene, context, p);
}
void trace_packet(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRay8* p) {
  rtcOccluded8(valid, scene, context, p);
}
void trace_packet(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRay16* p) {
  rtcOccluded16(valid, scene, context, p);
}

// The rays of a packet, with hits or without.
template <class Packet>
auto& rays_of(Packet& packet) {
  if constexpr (requires { packet.hit; }) {
    return packet.ray;
  } else {
    return packet;
  }
}

template <class Packet, std::size_t kWidth>
class PacketTracer final : public Tracer {
 public:
  PacketTracer(RTCScene scene, std::span<const Ray> rays, const FirstIds& first_ids,
               Promise promise)
      : scene_(scene), rays_(rays), first_ids_(first_ids), promise_(promise) {}

  std::string name() const override {
    return fmt::format("Embree {} {}", kWidth, suffix(promise_));
  }

  void reset() override {
    packets_.resize((rays_.size() + kWidth - 1) / kWidth);
    for (std::size_t i = 0; i < packets_.size() * kWidth; ++i) {
      // The last packet is filled up with its last ray, which then counts once.
      write(packets_[i / kWidth], i % kWidth, rays_[std::min(i, rays_.size() - 1)]);
    }
  }
  void trace() override {
    alignas(64) static constexpr auto kValid = all_valid();
    for_each_piece(rays_.size(), [&](std::size_t begin, std::size_t end) {
      RTCIntersectContext context = context_of(promise_);
      for (std::size_t i = begin; i < end; i += kWidth) {
        trace_packet(kValid.data(), scene_, &context, &packets_[i / kWidth]);
      }
    });
  }
  std::vector<Found> found() const override {
    std::vector<Found> result;
    result.reserve(rays_.size());
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const Packet& packet = packets_[i / kWidth];
      const std::size_t lane = i % kWidth;
      if constexpr (requires { packet.hit; }) {
        result.push_back(found_of(packet.ray.tfar[lane], packet.hit.geomID[lane],
                                  packet.hit.primID[lane], first_ids_));
      } else {
        result.push_back(found_of_occluded(packet.tfar[lane]));
      }
    }
    return result;
  }

 private:
  static_assert(kRaysPerPiece % kWidth == 0);

  static constexpr std::array<int, kWidth> all_valid() {
    std::array<int, kWidth> valid{};
    valid.fill(-1);
    return valid;
  }

  static void write(Packet& packet, std::size_t lane, const Ray& ray) {
    auto& r = rays_of(packet);
    r.org_x[lane] = ray.origin.x;
    r.org_y[lane] = ray.origin.y;
    r.org_z[lane] = ray.origin.z;
    r.tnear[lane] = ray.t_min;
    r.dir_x[lane] = ray.direction.x;
    r.dir_y[lane] = ray.direction.y;
    r.dir_z[lane] = ray.direction.z;
    r.time[lane] = 0.0f;
    r.tfar[lane] = ray.t_max;
    r.mask[lane] = ~0u;
    r.id[lane] = 0;
    r.flags[lane] = 0;
    if constexpr (requires { packet.hit; }) packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
  }

  RTCScene scene_;
  std::span<const Ray> rays_;
  std::vector<Packet> packets_;
  FirstIds first_ids_;
  Promise promise_;
};

template <class Record, class Packet8, class Packet16>
std::vector<std::unique_ptr<Tracer>> all_modes(RTCScene scene, std::span<const Ray> rays,
                                               const FirstIds& first_ids) {
  std::vector<std::unique_ptr<Tracer>> result;
  result.push_back(std::make_unique<SingleTracer<Record>>(scene, rays, first_ids));
  for (const Promise promise : {Promise::incoherent, Promise::coherent}) {
    const auto add = [&]<class Mode>(std::type_identity<Mode>) {
      result.push_back(std::make_unique<Mode>(scene, rays, first_ids, promise));
    };
    add(std::type_identity<StreamTracer<Record>>{});
    add(std::type_identity<PacketTracer<Packet8, 8>>{});
    add(std::type_identity<PacketTracer<Packet16, 16>>{});
  }
  return result;
}

}  // namespace

std::vector<std::unique_ptr<Tracer>> make_embree_tracers(RTCScene scene, std::span<const Ray> rays,
                                                         Query query, const FirstIds& first_ids) {
  return query == Query::closest
             ? all_modes<RTCRayHit, RTCRayHit8, RTCRayHit16>(scene, rays, first_ids)
             : all_modes<RTCRay, RTCRay8, RTCRay16>(scene, rays, first_ids);
}

}  // namespace dapple::bench
