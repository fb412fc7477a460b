#include "import/gltf/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "import/gltf/attributes.h"
#include "math/functions.h"

namespace dapple::gltf {
namespace {

enum class Interpolation { linear, step, cubic_spline };

// The keys of one sampler; `width` numbers belong to each.
struct Track {
  SharedFloats times;
  SharedFloats values;
  std::size_t width = 0;
  Interpolation interpolation = Interpolation::linear;

  std::size_t key_count() const { return times->values.size(); }
  // Of a cubic spline each key has an incoming tangent, a value and an outgoing tangent.
  const float* value(std::size_t key) const {
    const bool cubic = interpolation == Interpolation::cubic_spline;
    return values->values.data() + (cubic ? 3 * key + 1 : key) * width;
  }
  const float* incoming(std::size_t key) const { return value(key) - width; }
  const float* outgoing(std::size_t key) const { return value(key) + width; }
};

// Between two keys, `fraction` of the way.
struct Moment {
  std::size_t key = 0;
  double fraction = 0;
  double seconds = 0;  // from the key to the next
};

Moment moment_at(const Track& track, double time) {
  const auto& times = track.times->values;
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return {};
  const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
  if (after == times.end()) return {key, 0, 0};
  const double seconds = double{times[key + 1]} - times[key];
  return {key, seconds > 0 ? (time - times[key]) / seconds : 0, seconds};
}

std::vector<double> hermite(const Track& track, const Moment& at) {
  const double t = at.fraction, t2 = t * t, t3 = t2 * t;
  const double p0 = 2 * t3 - 3 * t2 + 1, p1 = -2 * t3 + 3 * t2;
  const double m0 = at.seconds * (t3 - 2 * t2 + t), m1 = at.seconds * (t3 - t2);
  std::vector<double> result(track.width);
  for (std::size_t i = 0; i < track.width; ++i) {
    result[i] = p0 * track.value(at.key)[i] + m0 * track.outgoing(at.key)[i] +
                p1 * track.value(at.key + 1)[i] + m1 * track.incoming(at.key + 1)[i];
  }
  return result;
}

// Along the shorter arc between unit quaternions.
std::vector<double> slerp(const float* a, const float* b, double t) {
  double cosine = 0;
  for (int i = 0; i < 4; ++i) cosine += double{a[i]} * b[i];
  const double sign = cosine < 0 ? -1 : 1;
  cosine = std::min(std::fabs(cosine), 1.0);
  double weight_a = 1 - t, weight_b = t;
  // Very near each other the arc is a line.
  if (cosine < 0.9999) {
    const double turns = arc_cosine(cosine) / (2 * std::numbers::pi);
    const double sine = sin_cos_turns(turns).sin;
    weight_a = sin_cos_turns((1 - t) * turns).sin / sine;
    weight_b = sin_cos_turns(t * turns).sin / sine;
  }
  std::vector<double> result(4);
  for (std::size_t i = 0; i < 4; ++i) result[i] = weight_a * a[i] + sign * weight_b * b[i];
  return result;
}

std::vector<double> sample(const Track& track, double time, bool rotates) {
  const Moment at = moment_at(track, time);
  const float* value = track.value(at.key);
  if (at.fraction == 0 || track.interpolation == Interpolation::step) {
    return {value, value + track.width};
  }
  if (track.interpolation == Interpolation::cubic_spline) return hermite(track, at);
  const float* next = track.value(at.key + 1);
  if (rotates) return slerp(value, next, at.fraction);
  std::vector<double> result(track.width);
  for (std::size_t i = 0; i < track.width; ++i) {
    result[i] = (1 - at.fraction) * value[i] + at.fraction * next[i];
  }
  return result;
}

class Animator {
 public:
  Animator(const Context& context, Accessors& accessors, double time, std::vector<NodePose>& poses)
      : document_(context.document), accessors_(accessors), time_(time), poses_(poses) {}

  Status apply(const JsonValue& animation, const std::string& pointer) {
    const JsonValue& channels = animation["channels"];
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const std::string place = fmt::format("{}/channels/{}", pointer, i);
      const JsonValue& target = channels[i]["target"];
      const std::string& path = target["path"].text();
      const auto node = target["node"].index();
      if (!target.has("node") || path == "pointer") continue;
      if (!node || *node >= poses_.size()) {
        return document_.error(place + "/target/node", "the node does not exist");
      }
      const auto sampler = channels[i]["sampler"].index();
      const JsonValue& json = animation["samplers"][sampler.value_or(0xffffffffu)];
      if (json.is_null()) return document_.error(place + "/sampler", "the sampler does not exist");
      if (!driven_.insert({*node, path}).second) continue;
      if (auto moved = move(poses_[*node], path, json, place); !moved) return moved;
    }
    return {};
  }

 private:
  static std::size_t width_of(const std::string& path) {
    return path == "rotation" ? 4 : path == "weights" ? 0 : 3;
  }

  Expected<Track> track(const JsonValue& sampler, std::size_t width, const std::string& place) {
    Track track;
    const std::string& name = sampler["interpolation"].text();
    if (name == "STEP") track.interpolation = Interpolation::step;
    if (name == "CUBICSPLINE") track.interpolation = Interpolation::cubic_spline;
    const auto times = accessors_.floats(sampler["input"].index().value_or(~0u));
    if (!times) return tl::unexpected(times.error());
    const auto values = accessors_.floats(sampler["output"].index().value_or(~0u));
    if (!values) return tl::unexpected(values.error());
    track.times = *times;
    track.values = *values;
    if (!std::is_sorted(track.times->values.begin(), track.times->values.end())) {
      return document_.error(place, "its times do not increase");
    }
    const std::size_t keys = track.key_count();
    const std::size_t per_key = track.interpolation == Interpolation::cubic_spline ? 3 : 1;
    track.width = width > 0 ? width : track.values->values.size() / keys / per_key;
    const bool right_type = track.values->components == (width > 0 ? width : 1);
    if (track.times->components != 1 || !right_type || track.width == 0 ||
        track.values->values.size() != keys * per_key * track.width) {
      return document_.error(place, "its times and values do not go together");
    }
    return track;
  }

  Status move(NodePose& pose, const std::string& path, const JsonValue& sampler,
              const std::string& place) {
    const auto keys = track(sampler, width_of(path), place);
    if (!keys) return tl::unexpected(keys.error());
    const std::vector<double> value = sample(*keys, time_, path == "rotation");
    if (path == "translation") pose.translation = {value[0], value[1], value[2]};
    if (path == "scale") pose.scale = {value[0], value[1], value[2]};
    if (path == "rotation") std::copy(value.begin(), value.end(), pose.rotation);
    if (path == "weights") pose.weights = value;
    return {};
  }

  const Document& document_;
  Accessors& accessors_;
  double time_;
  std::vector<NodePose>& poses_;
  std::set<std::pair<std::uint32_t, std::string>> driven_;
};

}  // namespace

Status animate(const Context& context, Accessors& accessors, double time,
               std::vector<NodePose>& poses) {
  const JsonValue& animations = context.document["animations"];
  if (animations.size() == 0) context.warn("", "the file has no animations: the time is ignored");
  Animator animator(context, accessors, time, poses);
  for (std::size_t i = 0; i < animations.size(); ++i) {
    auto applied = animator.apply(animations[i], fmt::format("/animations/{}", i));
    if (applied) continue;
    if (auto ok = context.tolerate(applied.error()); !ok) return ok;
  }
  return {};
}

}  // namespace dapple::gltf
