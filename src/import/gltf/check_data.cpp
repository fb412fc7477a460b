#include <fmt/format.h>

#include <algorithm>

#include "import/gltf/accessors.h"
#include "import/gltf/check.h"

namespace dapple::gltf {
namespace {

class DataChecker {
 public:
  explicit DataChecker(const Context& context)
      : context_(context), root_(context.document.root()) {}

  Status check() {
    const auto each = [&](const char* array, Status (DataChecker::*one)(const JsonValue&)) {
      const JsonValue& items = root_[array];
      for (std::size_t i = 0; i < items.size(); ++i) {
        pointer_ = fmt::format("/{}/{}", array, i);
        if (auto ok = (this->*one)(items[i]); !ok) return ok;
      }
      return Status();
    };
    return each("bufferViews", &DataChecker::view)
        .and_then([&] { return each("accessors", &DataChecker::accessor); })
        .and_then([&] { return each("cameras", &DataChecker::camera); })
        .and_then([&] { return each("images", &DataChecker::image); })
        .and_then([&] { return each("textures", &DataChecker::texture); });
  }

 private:
  [[nodiscard]] tl::unexpected<Error> error(const std::string& below, std::string message) const {
    return context_.document.error(pointer_ + below, std::move(message));
  }
  void warn_if(bool wrong, const std::string& below, const std::string& message) const {
    if (wrong) context_.warn(pointer_ + below, message);
  }
  static std::uint64_t offset_of(const JsonValue& value) {
    return value["byteOffset"].count().value_or(0);
  }
  const JsonValue& view_of(const JsonValue& value) const {
    return root_["bufferViews"][value["bufferView"].index().value_or(0xffffffffu)];
  }

  Status view(const JsonValue& v) {
    const JsonValue& buffer = root_["buffers"][v["buffer"].index().value_or(0xffffffffu)];
    const std::uint64_t length = v["byteLength"].count().value_or(0);
    const std::uint64_t buffer_length = buffer["byteLength"].count().value_or(0);
    if (offset_of(v) > buffer_length || length > buffer_length - offset_of(v)) {
      return error("",
                   fmt::format("it does not fit into the {} bytes of its buffer", buffer_length));
    }
    const auto stride = v["byteStride"].count();
    if (!stride) return {};
    if (*stride % 4 != 0) return error("/byteStride", "is no multiple of 4");
    warn_if(*stride > length, "/byteStride", "is greater than byteLength");
    warn_if(v.has("target") && v["target"].count() != 34962u, "/byteStride",
            "belongs only to vertex attributes");
    return {};
  }

  Status accessor(const JsonValue& a) {
    const std::uint64_t type = a["componentType"].count().value_or(0);
    const std::size_t components = component_count(a["type"].text());
    if (components == 0) {
      warn_if(true, "/type", a["type"].text() + " is not known: it cannot be read");
      return {};
    }
    const std::size_t component = component_bytes(type);
    const ElementSize element = element_size(type, a["type"].text());
    for (const char* bound : {"min", "max"}) {
      if (a.has(bound) && a[bound].size() != components) {
        return error(std::string("/") + bound, "has not one number for each component");
      }
    }
    warn_if(a["normalized"].bool_or(false) && component == 4, "/normalized",
            "has a meaning only for integers of 8 or 16 bits");
    warn_if(a.has("byteOffset") && !a.has("bufferView"), "/byteOffset", "stands without a view");
    warn_if(offset_of(a) % component != 0, "/byteOffset", "is not aligned to the component type");
    const std::uint64_t count = a["count"].count().value_or(0);
    const JsonValue& sparse = a["sparse"];
    if (sparse.is_object() && sparse["count"].count().value_or(0) > count) {
      return error("/sparse/count", "is greater than the count of the accessor");
    }
    const JsonValue& v = view_of(a);
    if (!v.is_object()) return {};
    const std::uint64_t stride = v["byteStride"].count().value_or(element.step);
    if (stride < element.last)
      return error("", "one element is larger than the stride of its view");
    std::uint64_t end = 0;
    if (__builtin_mul_overflow(count - 1, stride, &end) ||
        __builtin_add_overflow(end, element.last + offset_of(a), &end) ||
        end > v["byteLength"].count().value_or(0)) {
      return error("", fmt::format("{} elements do not fit into its view", count));
    }
    const bool matrix = a["type"].text().starts_with("MAT");
    warn_if((offset_of(a) + offset_of(v)) % (matrix ? 4 : component) != 0, "",
            "its data is not aligned");
    return {};
  }

  Status camera(const JsonValue& c) {
    const std::string& type = c["type"].text();
    if (!c.has(type)) return error("/" + type, "is missing");
    const JsonValue& o = c[type];
    const bool other = c.has(type == "perspective" ? "orthographic" : "perspective");
    warn_if(other, "", "describes two types of cameras");
    warn_if(o.has("zfar") && o["zfar"].number_or(0) <= o["znear"].number_or(0), "/" + type,
            "zfar is not greater than znear");
    if (type == "orthographic" && (o["xmag"].number_or(0) == 0 || o["ymag"].number_or(0) == 0)) {
      return error("/orthographic", "its magnification is zero");
    }
    warn_if(o["xmag"].number_or(0) < 0 || o["ymag"].number_or(0) < 0, "/orthographic",
            "its magnification is negative");
    return {};
  }

  Status image(const JsonValue& i) {
    if (i.has("uri") == i.has("bufferView")) {
      return error("", "has not exactly one of uri and bufferView");
    }
    const std::string& type = i["mimeType"].text();
    warn_if(i.has("bufferView") && !i.has("mimeType"), "/mimeType", "is missing");
    warn_if(i.has("mimeType") && type != "image/png" && type != "image/jpeg" &&
                type != "image/webp" && type != "image/ktx2",
            "/mimeType", type + " is not a type of glTF's images");
    warn_if(type == "image/webp" && !is_declared("EXT_texture_webp"), "/mimeType",
            "image/webp needs EXT_texture_webp among extensionsUsed");
    warn_if(view_of(i).has("byteStride"), "/bufferView", "an image has no stride");
    return {};
  }

  Status texture(const JsonValue& t) {
    const JsonValue& image = root_["images"][t["source"].index().value_or(0xffffffffu)];
    warn_if(image["mimeType"].text() == "image/webp", "/source",
            "a WebP image belongs into the extension EXT_texture_webp");
    return {};
  }

  bool is_declared(std::string_view name) const {
    const auto& used = root_["extensionsUsed"].items();
    return std::any_of(used.begin(), used.end(),
                       [&](const JsonValue& item) { return item.text() == name; });
  }

  const Context& context_;
  const JsonValue& root_;
  std::string pointer_;  // of the object that is being checked
};

}  // namespace

Status check_data(const Context& context) { return DataChecker(context).check(); }

}  // namespace dapple::gltf
