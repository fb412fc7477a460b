#include "import/gltf/primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "import/gltf/attributes.h"
#include "import/gltf/draco.h"
#include "import/gltf/topology.h"
#include "import/vertex_arrays.h"

namespace dapple::gltf {
namespace {

constexpr std::uint32_t kUnused = 0xffffffffu;

template <class T>
void keep(std::vector<T>& values, const std::vector<std::uint32_t>& kept,
          std::size_t per_vertex = 1) {
  if (values.empty()) return;
  std::vector<T> fewer;
  fewer.reserve(kept.size() * per_vertex);
  for (const std::uint32_t vertex : kept) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(vertex * per_vertex);
    fewer.insert(fewer.end(), first, first + static_cast<std::ptrdiff_t>(per_vertex));
  }
  values = std::move(fewer);
}

template <class Attributes>
void keep_attributes(Attributes& from, const std::vector<std::uint32_t>& kept) {
  keep(from.positions, kept);
  keep(from.normals, kept);
  keep(from.tangents, kept);
  for (auto& uvs : from.uvs) keep(uvs, kept);
  keep(from.colours, kept);
}

// Leaves out what `indices` does not name, so that many primitives can share one large array.
void drop_unused_vertices(std::vector<std::uint32_t>& indices, Primitive& primitive) {
  std::vector<std::uint32_t> new_number(primitive.vertices.positions.size(), kUnused);
  for (const std::uint32_t index : indices) new_number[index] = 0;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < new_number.size(); ++i) {
    if (new_number[i] == kUnused) continue;
    new_number[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(i);
  }
  if (kept.size() == new_number.size()) return;
  keep_attributes(primitive.vertices, kept);
  for (MorphTarget& target : primitive.targets) keep_attributes(target, kept);
  keep(primitive.influences.joints, kept, primitive.influences.per_vertex);
  keep(primitive.influences.weights, kept, primitive.influences.per_vertex);
  for (std::uint32_t& index : indices) index = new_number[index];
}

// The greatest number of its component type.
std::uint32_t restart_index(const JsonValue& accessor) {
  const std::size_t bytes = component_bytes(accessor["componentType"].count().value_or(0));
  return 0xffffffffu >> (32 - 8 * bytes);
}

Expected<std::vector<std::uint32_t>> read_indices(Accessors& accessors, const JsonValue& json,
                                                  Primitive& primitive) {
  const auto index = json["indices"].index();
  if (!index) return fail(Errc::bad_data, "indices", "is not the number of an accessor");
  auto elements = accessors.integers(*index);
  if (!elements) return tl::unexpected(elements.error());
  if (elements->components != 1) return fail(Errc::bad_data, "indices", "is not of scalars");
  const std::uint32_t restart = restart_index(accessors.context().document["accessors"][*index]);
  const auto count = std::count(elements->values.begin(), elements->values.end(), restart);
  if (count > 0) {
    primitive.doubts.push_back(fmt::format(
        "{} of its indices are {}, which restarts primitives elsewhere; here it is a vertex", count,
        restart));
  }
  return std::move(elements->values);
}

std::vector<std::uint32_t> counted_indices(std::size_t count) {
  std::vector<std::uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

Status check_indices(const std::vector<std::uint32_t>& indices, std::size_t vertex_count) {
  std::size_t bad = 0, first = 0;
  for (std::size_t i = indices.size(); i-- > 0;) {
    if (indices[i] < vertex_count) continue;
    ++bad;
    first = i;
  }
  if (bad == 0) return {};
  return fail(
      Errc::bad_data, "indices",
      fmt::format("{} of its {} indices are beyond the {} vertices, the first at place {}: {}", bad,
                  indices.size(), vertex_count, first, indices[first]));
}

class PrimitiveReader {
 public:
  PrimitiveReader(Accessors& accessors, const Context& context, const JsonValue& json)
      : accessors_(accessors), context_(context), json_(json) {}

  Expected<Primitive> read() {
    Primitive primitive;
    std::vector<std::uint32_t> indices;
    const JsonValue& draco = json_["extensions"]["KHR_draco_mesh_compression"];
    const Status status =
        (draco.is_object() ? read_draco(draco, primitive, indices) : read_plain(primitive, indices))
            .and_then([&] { return read_targets(primitive); })
            .and_then([&] { return check_indices(indices, primitive.vertices.positions.size()); });
    if (!status) return tl::unexpected(status.error());
    drop_unused_vertices(indices, primitive);
    const auto mode = json_.has("mode") ? json_["mode"].index() : kTriangles;
    if (!mode || *mode > kTriangleFan) return fail(Errc::bad_data, "mode", "is not from 0 to 6");
    assemble(indices, *mode, primitive);
    return primitive;
  }

 private:
  Status read_plain(Primitive& primitive, std::vector<std::uint32_t>& indices) {
    AccessorSource source(accessors_, json_["attributes"]);
    if (auto read = read_attributes(source, primitive); !read) return read;
    if (!json_.has("indices")) {
      indices = counted_indices(primitive.vertices.positions.size());
      return {};
    }
    auto read = read_indices(accessors_, json_, primitive);
    if (!read) return tl::unexpected(read.error());
    indices = std::move(*read);
    if (primitive.vertices.positions.empty()) indices.clear();
    return {};
  }

  Status read_draco(const JsonValue& draco, Primitive& primitive,
                    std::vector<std::uint32_t>& indices) {
    auto source = DracoSource::decode(accessors_, context_, draco, json_["attributes"]);
    if (!source) return tl::unexpected(source.error());
    if (auto read = read_attributes(**source, primitive); !read) return read;
    indices = (*source)->take_indices();
    return {};
  }

  Status read_targets(Primitive& primitive) {
    const JsonValue& targets = json_["targets"];
    if (targets.size() > kMaxMorphTargets) return fail(Errc::bad_data, "targets", "too many");
    const std::size_t count = primitive.vertices.positions.size();
    if (auto taken =
            context_.builder.budget().take(targets.size() * count, kMaxVertexBytes, "targets");
        !taken) {
      return taken;
    }
    for (const JsonValue& names : targets.items()) {
      AccessorSource source(accessors_, names);
      auto target = read_target(source, count);
      if (!target) return tl::unexpected(target.error());
      primitive.targets.push_back(std::move(*target));
    }
    return {};
  }

  Accessors& accessors_;
  const Context& context_;
  const JsonValue& json_;
};

}  // namespace

Expected<Primitive> read_primitive(Accessors& accessors, const Context& context,
                                   const JsonValue& json, const std::string& pointer) {
  auto primitive = PrimitiveReader(accessors, context, json).read();
  if (primitive) {
    for (const std::string& doubt : primitive->doubts) context.warn(pointer, doubt);
    return primitive;
  }
  // Errors about an accessor know their place; those about the primitive say only which part.
  Error error = primitive.error();
  if (error.place.find(", /") == std::string::npos) {
    error.place = context.document.place(pointer + (error.place.empty() ? "" : "/") + error.place);
  } else {
    error.message += fmt::format(" (read for {})", pointer);
  }
  return tl::unexpected(std::move(error));
}

}  // namespace dapple::gltf
