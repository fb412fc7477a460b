#include "import/gltf/accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace dapple::gltf {
namespace {

constexpr std::size_t kRecentAccessors = 12;

template <class Stored>
Stored load(const std::byte* at) {
  Stored value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class T, class Stored>
T converted(Stored value, bool normalised) {
  if constexpr (std::is_same_v<T, float> && std::is_integral_v<Stored>) {
    if (!normalised) return static_cast<float>(value);
    const float scaled =
        static_cast<float>(value) / static_cast<float>(std::numeric_limits<Stored>::max());
    return std::max(scaled, -1.0f);
  } else {
    return static_cast<T>(value);
  }
}

template <class T, class Stored>
void read_element(const std::byte* from, const Layout& layout, T* to) {
  for (std::size_t i = 0; i < layout.components; ++i) {
    const std::byte* at =
        from + i / layout.rows * layout.column_bytes + i % layout.rows * sizeof(Stored);
    to[i] = converted<T>(load<Stored>(at), layout.normalised);
  }
}

template <class T, class Stored, class Position>
void read_elements(std::span<const std::byte> bytes, const Layout& layout, std::size_t count,
                   std::vector<T>& values, Position position) {
  for (std::size_t i = 0; i < count; ++i) {
    read_element<T, Stored>(bytes.data() + layout.offset + i * layout.stride, layout,
                            values.data() + position(i) * layout.components);
  }
}

// Element i of `bytes` becomes element position(i) of `values`.
template <class T, class Position>
void read_any(std::span<const std::byte> bytes, const Layout& layout, std::size_t count,
              std::vector<T>& values, Position position) {
  switch (layout.component_type) {
    case kByte:
      return read_elements<T, std::int8_t>(bytes, layout, count, values, position);
    case kUnsignedByte:
      return read_elements<T, std::uint8_t>(bytes, layout, count, values, position);
    case kShort:
      return read_elements<T, std::int16_t>(bytes, layout, count, values, position);
    case kUnsignedShort:
      return read_elements<T, std::uint16_t>(bytes, layout, count, values, position);
    case kUnsignedInt:
      return read_elements<T, std::uint32_t>(bytes, layout, count, values, position);
    default:
      return read_elements<T, float>(bytes, layout, count, values, position);
  }
}

// All of the elements lie within `size` bytes.
bool fits(const Layout& layout, std::uint64_t count, std::uint64_t size) {
  std::uint64_t end = 0;
  return count > 0 && !__builtin_mul_overflow(count - 1, layout.stride, &end) &&
         !__builtin_add_overflow(end, layout.offset, &end) &&
         !__builtin_add_overflow(end, layout.used_bytes, &end) && end <= size;
}

struct Reader {
  Buffers& buffers;
  const JsonValue& json;
  std::string pointer;

  tl::unexpected<Error> error(const std::string& below, std::string message) const {
    return buffers.context().document.error(pointer + below, std::move(message));
  }

  Expected<Layout> layout() const {
    const std::uint64_t component_type = json["componentType"].count().value_or(0);
    Layout layout = packed_layout(component_type, json["type"].text());
    if (layout.element_bytes == 0) return error("", "its type or componentType is unknown");
    layout.normalised = json["normalized"].bool_or(false);
    layout.offset = json["byteOffset"].count().value_or(0);
    const auto view = json["bufferView"].index();
    if (!view) return layout;
    const JsonValue& stride = buffers.context().document["bufferViews"][*view]["byteStride"];
    if (stride.is_number()) layout.stride = stride.count().value_or(0);
    if (layout.stride < layout.used_bytes) {
      return error("", "the byteStride of its buffer view is less than one element");
    }
    return layout;
  }

  // The bytes behind json[below]'s bufferView, checked to hold `count` elements.
  Expected<std::span<const std::byte>> bytes(const JsonValue& from, const std::string& below,
                                             const Layout& layout, std::uint64_t count) const {
    const auto view = from["bufferView"].index();
    if (!view) return error(below + "/bufferView", "is not the number of a buffer view");
    const auto bytes = buffers.view(*view);
    if (bytes && !fits(layout, count, bytes->size())) {
      return error(below, fmt::format("{} elements do not fit into the {} bytes of buffer view {}",
                                      count, bytes->size(), *view));
    }
    return bytes;
  }

  template <class T>
  Status apply_sparse(const Layout& base, Elements<T>& elements) const {
    const JsonValue& sparse = json["sparse"];
    const auto count = sparse["count"].count();
    if (!count || *count == 0 || *count > elements.count()) {
      return error("/sparse/count", "is not from 1 to the count of the accessor");
    }
    Layout index_layout =
        packed_layout(sparse["indices"]["componentType"].count().value_or(0), "SCALAR");
    const std::uint64_t type = index_layout.component_type;
    if (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt) {
      return error("/sparse/indices/componentType", "is not an unsigned integer");
    }
    index_layout.offset = sparse["indices"]["byteOffset"].count().value_or(0);
    const auto index_bytes = bytes(sparse["indices"], "/sparse/indices", index_layout, *count);
    if (!index_bytes) return tl::unexpected(index_bytes.error());
    std::vector<std::uint32_t> indices(*count);
    read_any(*index_bytes, index_layout, *count, indices, [](std::size_t i) { return i; });
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] < elements.count() && (i == 0 || indices[i] > indices[i - 1])) continue;
      return error(
          "/sparse/indices",
          fmt::format("index {} at place {} does not exist or does not increase", indices[i], i));
    }
    Layout value_layout = packed_layout(base.component_type, json["type"].text());
    value_layout.normalised = base.normalised;
    value_layout.offset = sparse["values"]["byteOffset"].count().value_or(0);
    const auto value_bytes = bytes(sparse["values"], "/sparse/values", value_layout, *count);
    if (!value_bytes) return tl::unexpected(value_bytes.error());
    read_any(*value_bytes, value_layout, *count, elements.values,
             [&](std::size_t i) { return indices[i]; });
    return {};
  }
};

// Warns when the numbers are not those that min and max declare.
void check_bounds(const Context& context, std::uint32_t index, const FloatElements& elements) {
  const JsonValue& json = context.document["accessors"][index];
  if (!is_stored(json)) return;
  for (std::size_t c = 0; c < elements.components; ++c) {
    if (json["normalized"].bool_or(false) || !json.has("min") || !json.has("max")) return;
    float low = std::numeric_limits<float>::infinity(), high = -low;
    for (std::size_t i = 0; i < elements.count(); ++i) {
      low = std::min(low, elements[i][c]);
      high = std::max(high, elements[i][c]);
    }
    if (low == static_cast<float>(json["min"][c].number_or(0)) &&
        high == static_cast<float>(json["max"][c].number_or(0))) {
      continue;
    }
    return context.warn(fmt::format("/accessors/{}", index),
                        "its numbers are not from its min to its max");
  }
}

}  // namespace

bool is_stored(const JsonValue& accessor) {
  return accessor.has("bufferView") || accessor.has("sparse");
}

template <class T>
Expected<Elements<T>> Accessors::read(std::uint32_t index) {
  const Reader reader{buffers_, buffers_.context().document["accessors"][index],
                      fmt::format("/accessors/{}", index)};
  if (reader.json.is_null()) return reader.error("", "the accessor does not exist");
  read_.insert(index);
  const auto count = reader.json["count"].count();
  if (!count || *count == 0) return reader.error("/count", "is not a positive integer");
  const auto layout = reader.layout();
  if (!layout) return tl::unexpected(layout.error());
  const bool is_signed = layout->component_type == kByte || layout->component_type == kShort ||
                         layout->component_type == kFloat;
  if (std::is_integral_v<T> && is_signed) return reader.error("", "is not of unsigned integers");

  std::span<const std::byte> bytes;
  if (reader.json.has("bufferView")) {
    const auto there = reader.bytes(reader.json, "", *layout, *count);
    if (!there) return tl::unexpected(there.error());
    bytes = *there;
  }
  ByteBudget& budget = buffers_.context().builder.budget();
  const std::uint64_t element_size = layout->components * sizeof(T);
  if (auto taken = budget.take(*count, element_size, reader.pointer); !taken) {
    return reader.error("", taken.error().message);
  }
  Elements<T> elements{layout->components, std::vector<T>(*count * layout->components)};
  if (!bytes.empty()) {
    read_any(bytes, *layout, *count, elements.values, [](std::size_t i) { return i; });
  }
  if (reader.json.has("sparse")) {
    if (auto applied = reader.apply_sparse(*layout, elements); !applied) {
      return tl::unexpected(applied.error());
    }
  }
  return elements;
}

Expected<std::shared_ptr<const FloatElements>> Accessors::floats(std::uint32_t index) {
  for (const auto& [known, elements] : recent_) {
    if (known == index) return elements;
  }
  auto elements = read<float>(index);
  if (!elements) return tl::unexpected(elements.error());
  const auto is_bad = [](float value) { return !std::isfinite(value); };
  const auto bad = std::find_if(elements->values.begin(), elements->values.end(), is_bad);
  if (bad != elements->values.end()) {
    const Context& context = buffers_.context();
    const auto position = static_cast<std::size_t>(bad - elements->values.begin());
    const auto error = context.document.error(
        fmt::format("/accessors/{}", index),
        fmt::format("{} of its numbers are not finite, first that of element {}",
                    std::count_if(elements->values.begin(), elements->values.end(), is_bad),
                    position / elements->components));
    if (auto status = context.tolerate(error.value()); !status) {
      return tl::unexpected(status.error());
    }
  }
  check_bounds(buffers_.context(), index, *elements);
  recent_.emplace_front(index, std::make_shared<const FloatElements>(std::move(*elements)));
  if (recent_.size() > kRecentAccessors) recent_.pop_back();
  return recent_.front().second;
}

Expected<IntegerElements> Accessors::integers(std::uint32_t index) {
  return read<std::uint32_t>(index);
}

}  // namespace dapple::gltf
