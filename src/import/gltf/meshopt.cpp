#include "import/gltf/meshopt.h"

#include <meshoptimizer.h>

#include <string_view>

namespace dapple::gltf {
namespace {

// What the decoders require of count and stride; they check it only by assertions.
bool is_allowed(std::string_view mode, std::string_view filter, std::uint64_t count,
                std::uint64_t stride) {
  if (mode == "ATTRIBUTES") {
    if (stride == 0 || stride % 4 != 0 || stride > 256) return false;
    if (filter == "OCTAHEDRAL") return stride == 4 || stride == 8;
    return filter != "QUATERNION" || stride == 8;
  }
  const bool known = mode == "INDICES" || (mode == "TRIANGLES" && count % 3 == 0);
  return known && (stride == 2 || stride == 4) && filter == "NONE";
}

int decode(std::string_view mode, std::vector<std::byte>& data, std::size_t count,
           std::size_t stride, std::span<const std::byte> bytes) {
  const auto* packed = reinterpret_cast<const unsigned char*>(bytes.data());
  if (mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(data.data(), count, stride, packed, bytes.size());
  }
  if (mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(data.data(), count, stride, packed, bytes.size());
  }
  return meshopt_decodeIndexSequence(data.data(), count, stride, packed, bytes.size());
}

// Returns false for a filter that is unknown.
bool unfilter(std::string_view filter, std::vector<std::byte>& data, std::size_t count,
              std::size_t stride) {
  if (filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(data.data(), count, stride);
  } else if (filter == "QUATERNION") {
    meshopt_decodeFilterQuat(data.data(), count, stride);
  } else if (filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(data.data(), count, stride);
  }
  return filter == "NONE" || filter == "OCTAHEDRAL" || filter == "QUATERNION" ||
         filter == "EXPONENTIAL";
}

}  // namespace

Expected<std::vector<std::byte>> unpack_meshopt(const JsonValue& extension,
                                                std::span<const std::byte> bytes,
                                                ByteBudget& budget) {
  const auto count = extension["count"].count();
  const auto stride = extension["byteStride"].count();
  const std::string& mode = extension["mode"].text();
  const std::string filter = extension.has("filter") ? extension["filter"].text() : "NONE";
  if (!count || !stride || !is_allowed(mode, filter, *count, *stride)) {
    return fail(Errc::bad_data, "", "mode, filter, count and byteStride do not go together");
  }
  // The densest stream has 4 bits for a triangle, or 16 vertices with a header of 2 bits a byte.
  if (*count / 512 > bytes.size()) return fail(Errc::bad_data, "", "too few bytes for its count");
  if (auto taken = budget.take(*count, *stride, "compressed buffer view"); !taken) {
    return tl::unexpected(taken.error());
  }
  std::vector<std::byte> data(*count * *stride);
  if (decode(mode, data, *count, *stride, bytes) != 0) {
    return fail(Errc::bad_data, "", "its compressed data is damaged");
  }
  if (!unfilter(filter, data, *count, *stride)) {
    return fail(Errc::bad_data, "", "unknown filter " + filter);
  }
  return data;
}

}  // namespace dapple::gltf
