#include "import/gltf/attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dapple::gltf {
namespace {

float finite_or_zero(float value) { return std::isfinite(value) ? value : 0.0f; }

Vec2f vec2(const float* v) { return {finite_or_zero(v[0]), finite_or_zero(v[1])}; }
Vec3f vec3(const float* v) {
  return {finite_or_zero(v[0]), finite_or_zero(v[1]), finite_or_zero(v[2])};
}
// Not made finite: triangles at such positions are left out.
Vec3f position(const float* v) { return {v[0], v[1], v[2]}; }
Vec4f colour(const float* v, std::size_t components) {
  return {finite_or_zero(v[0]), finite_or_zero(v[1]), finite_or_zero(v[2]),
          components == 4 ? finite_or_zero(v[3]) : 1.0f};
}

// Zero stays zero, which means: none.
Vec3f unit(const Vec3f& v) {
  const float norm = length(v);
  return norm > 0 && std::isfinite(norm) ? v / norm : Vec3f();
}

Status check_shape(const FloatElements& elements, const std::string& name, std::size_t count,
                   std::size_t least_components, std::size_t most_components) {
  if (elements.components < least_components || elements.components > most_components) {
    return fail(Errc::bad_data, "attributes/" + name, "its accessor has the wrong type");
  }
  if (elements.count() != count) {
    return fail(
        Errc::bad_data, "attributes/" + name,
        fmt::format("it has {} elements where there are {} vertices", elements.count(), count));
  }
  return {};
}

// Reads `name`, if it is there, into `to` with convert(pointer to the numbers, components).
template <class T, class Convert>
Status read_into(AttributeSource& source, const std::string& name, std::size_t count,
                 std::size_t least_components, std::size_t most_components, std::vector<T>& to,
                 Convert convert) {
  const auto elements = source.floats(name);
  if (!elements) return tl::unexpected(elements.error());
  if (*elements == nullptr) return {};
  const FloatElements& e = **elements;
  if (auto ok = check_shape(e, name, count, least_components, most_components); !ok) return ok;
  to.resize(count);
  for (std::size_t i = 0; i < count; ++i) to[i] = convert(e[i], e.components);
  return {};
}

Status read_influences(AttributeSource& source, std::size_t count, Influences& influences) {
  std::vector<IntegerElements> joints;
  std::vector<SharedFloats> weights;
  for (int set = 0;; ++set) {
    auto more_joints = source.integers(fmt::format("JOINTS_{}", set));
    if (!more_joints) return tl::unexpected(more_joints.error());
    const std::string name = fmt::format("WEIGHTS_{}", set);
    const auto more_weights = source.floats(name);
    if (!more_weights) return tl::unexpected(more_weights.error());
    if (!*more_joints || *more_weights == nullptr) break;
    if (auto ok = check_shape(**more_weights, name, count, 4, 4); !ok) return ok;
    if ((*more_joints)->components != 4 || (*more_joints)->count() != count) {
      return fail(Errc::bad_data, fmt::format("attributes/JOINTS_{}", set),
                  "its accessor has the wrong type or count");
    }
    joints.push_back(std::move(**more_joints));
    weights.push_back(*more_weights);
  }
  influences.per_vertex = joints.size() * 4;
  for (std::size_t vertex = 0; vertex < count; ++vertex) {
    for (std::size_t set = 0; set < joints.size(); ++set) {
      influences.joints.insert(influences.joints.end(), joints[set][vertex],
                               joints[set][vertex] + 4);
      const float* w = (*weights[set])[vertex];
      for (int i = 0; i < 4; ++i) influences.weights.push_back(finite_or_zero(w[i]));
    }
  }
  return {};
}

// Counts the elements of an attribute whose numbers break a rule, for a warning.
template <class Broken>
void doubt(AttributeSource& source, const std::string& name, Primitive& primitive, const char* rule,
           Broken broken) {
  const auto elements = source.floats(name);
  if (!elements || *elements == nullptr) return;
  const FloatElements& e = **elements;
  std::size_t count = 0;
  for (std::size_t i = 0; i < e.count(); ++i) count += broken(e[i], e.components) ? 1 : 0;
  if (count == 0) return;
  primitive.doubts.push_back(
      fmt::format("{} of the {} elements of {} {}", count, e.count(), name, rule));
}

bool is_no_unit(const float* v, std::size_t) {
  return std::fabs(dot(vec3(v), vec3(v)) - 1) > 0.05f;
}

bool is_outside_unit(const float* v, std::size_t components) {
  return std::any_of(v, v + components, [](float x) { return !(x >= 0 && x <= 1); });
}

void doubt_attributes(AttributeSource& source, Primitive& primitive) {
  doubt(source, "NORMAL", primitive, "are not of unit length", is_no_unit);
  doubt(source, "TANGENT", primitive, "are not of unit length", is_no_unit);
  doubt(source, "TANGENT", primitive, "have no side of 1 or -1",
        [](const float* v, std::size_t n) { return n == 4 && std::fabs(v[3]) != 1; });
  doubt(source, "COLOR_0", primitive, "are not from 0 to 1", is_outside_unit);
  doubt(source, "WEIGHTS_0", primitive, "are not from 0 to 1", is_outside_unit);
}

}  // namespace

Expected<SharedFloats> AccessorSource::floats(const std::string& name) {
  if (!names_.has(name)) return SharedFloats();
  const auto index = names_[name].index();
  if (!index) return fail(Errc::bad_data, "attributes/" + name, "is not the number of an accessor");
  return accessors_.floats(*index);
}

Expected<std::optional<IntegerElements>> AccessorSource::integers(const std::string& name) {
  if (!names_.has(name)) return std::optional<IntegerElements>();
  const auto index = names_[name].index();
  if (!index) return fail(Errc::bad_data, "attributes/" + name, "is not the number of an accessor");
  auto elements = accessors_.integers(*index);
  if (!elements) return tl::unexpected(elements.error());
  return std::optional<IntegerElements>(std::move(*elements));
}

Status read_attributes(AttributeSource& source, Primitive& primitive) {
  Vertices& v = primitive.vertices;
  const auto positions = source.floats("POSITION");
  if (!positions) return tl::unexpected(positions.error());
  if (*positions == nullptr) return {};
  const std::size_t count = (*positions)->count();
  const auto read = [&](const char* name, std::size_t least, std::size_t most, auto& to,
                        auto convert) {
    return read_into(source, name, count, least, most, to,
                     [&](const float* from, std::size_t) { return convert(from); });
  };
  const auto unit_normal = [](const float* from) { return unit(vec3(from)); };
  const auto unit_tangent = [](const float* from) {
    const Vec3f t = unit(vec3(from));
    return Vec4f{t.x, t.y, t.z, from[3] < 0 ? -1.0f : 1.0f};
  };
  return read("POSITION", 3, 3, v.positions, position)
      .and_then([&] { return read("NORMAL", 3, 3, v.normals, unit_normal); })
      .and_then([&] { return read("TANGENT", 4, 4, v.tangents, unit_tangent); })
      .and_then([&] { return read("TEXCOORD_0", 2, 2, v.uvs[0], vec2); })
      .and_then([&] { return read("TEXCOORD_1", 2, 2, v.uvs[1], vec2); })
      .and_then([&] { return read_into(source, "COLOR_0", count, 3, 4, v.colours, colour); })
      .and_then([&] { return read_influences(source, count, primitive.influences); })
      .map([&] { doubt_attributes(source, primitive); });  // their types are proven by now
}

Expected<MorphTarget> read_target(AttributeSource& source, std::size_t count) {
  MorphTarget target;
  const auto read = [&](const char* name, std::size_t most, auto& to, auto convert) {
    return read_into(source, name, count, std::min<std::size_t>(most, 3), most, to,
                     [&](const float* from, std::size_t components) {
                       if constexpr (std::is_invocable_v<decltype(convert), const float*>) {
                         return convert(from);
                       } else {
                         return convert(from, components);
                       }
                     });
  };
  const auto colour_delta = [](const float* from, std::size_t components) {
    Vec4f delta = colour(from, components);
    if (components == 3) delta.w = 0;
    return delta;
  };
  const Status status =
      read("POSITION", 3, target.positions, position)
          .and_then([&] { return read("NORMAL", 3, target.normals, vec3); })
          .and_then([&] { return read("TANGENT", 3, target.tangents, vec3); })
          .and_then([&] { return read("TEXCOORD_0", 2, target.uvs[0], vec2); })
          .and_then([&] { return read("TEXCOORD_1", 2, target.uvs[1], vec2); })
          .and_then([&] { return read("COLOR_0", 4, target.colours, colour_delta); });
  if (!status) return tl::unexpected(status.error());
  return target;
}

}  // namespace dapple::gltf
