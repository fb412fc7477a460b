#include <fmt/format.h>

#include <cmath>
#include <set>

#include "import/gltf/attributes.h"
#include "import/gltf/check.h"
#include "import/gltf/pictures.h"
#include "import/limits.h"

namespace dapple::gltf {
namespace {

// Whatever is wrong here is a warning: the picture does not show it.
class ContentChecker {
 public:
  ContentChecker(const Context& context, Buffers& buffers, Accessors& accessors)
      : context_(context),
        root_(context.document.root()),
        buffers_(buffers),
        accessors_(accessors) {}

  void meshes(const std::vector<PlacedNode>& nodes) {
    std::set<std::uint32_t> shown;
    for (const PlacedNode& node : nodes) {
      shown.insert(root_["nodes"][node.index]["mesh"].index().value_or(0xffffffffu));
    }
    for (std::uint32_t m = 0; m < root_["meshes"].size(); ++m) {
      const JsonValue& primitives = root_["meshes"][m]["primitives"];
      for (std::size_t p = 0; p < primitives.size() && !shown.contains(m); ++p) {
        const std::string pointer = fmt::format("/meshes/{}/primitives/{}", m, p);
        const auto read = read_primitive(accessors_, context_, primitives[p], pointer);
        if (!read) context_.log.warn(to_string(read.error()));
      }
    }
  }

  void animations() {
    const JsonValue& all = root_["animations"];
    for (std::size_t a = 0; a < all.size(); ++a) {
      std::set<std::pair<std::uint32_t, bool>> seen;
      for (const JsonValue& channel : all[a]["channels"].items()) {
        const auto sampler = channel["sampler"].index().value_or(0);
        const bool rotates = channel["target"]["path"].text() == "rotation";
        if (!seen.insert({sampler, rotates}).second) continue;
        check_track(all[a]["samplers"][sampler], rotates,
                    fmt::format("/animations/{}/samplers/{}", a, sampler));
      }
    }
  }

  void skins() {
    for (std::size_t s = 0; s < root_["skins"].size(); ++s) {
      const SharedFloats matrices = floats(root_["skins"][s]["inverseBindMatrices"]);
      if (!matrices || matrices->components != 16) continue;
      std::size_t bad = 0;
      for (std::size_t i = 0; i < matrices->count(); ++i) {
        const float* m = (*matrices)[i];
        bad += m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1;
      }
      warn_of(bad, fmt::format("/skins/{}/inverseBindMatrices", s),
              "of its matrices have a last row that is not 0 0 0 1");
    }
  }

  // Those that nothing has read yet.
  void accessors() {
    const JsonValue& all = root_["accessors"];
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (!is_stored(all[i]) || accessors_.was_read(i)) continue;
      const auto read = accessors_.floats(i);
      if (!read) context_.log.warn(to_string(read.error()));
    }
  }

  // Decoding what nobody sees would take longer than many a picture: only where nothing is seen.
  void images(const std::set<std::uint32_t>& read, bool decode) {
    for (std::uint32_t i = 0; i < root_["images"].size(); ++i) {
      if (read.contains(i)) continue;
      Pictures pictures(context_, buffers_);
      const auto encoded = pictures.encoded(i);
      if (!encoded) {
        context_.log.warn(to_string(encoded.error()) + "; no surface shows it");
        continue;
      }
      if (!decode || image_type(encoded->bytes) == "image/ktx2") continue;
      const auto decoded = decode_raw_image(encoded->bytes, kMaxImagePixels);
      if (!decoded) context_.log.warn(encoded->place + ": " + to_string(decoded.error()));
    }
  }

 private:
  SharedFloats floats(const JsonValue& number) {
    const auto index = number.index();
    if (!index || !is_stored(root_["accessors"][*index])) return nullptr;
    const auto read = accessors_.floats(*index);
    if (!read) context_.log.warn(to_string(read.error()));
    return read.value_or(nullptr);
  }

  void warn_of(std::size_t count, const std::string& pointer, const char* what) const {
    if (count > 0) context_.warn(pointer, fmt::format("{} {}", count, what));
  }

  void check_track(const JsonValue& sampler, bool rotates, const std::string& pointer) {
    if (const SharedFloats times = floats(sampler["input"])) {
      const auto& t = times->values;
      std::size_t bad = !t.empty() && t[0] < 0;
      for (std::size_t i = 1; i < t.size(); ++i) bad += !(t[i] > t[i - 1]);
      warn_of(bad, pointer + "/input", "of its times are negative or do not increase");
    }
    const SharedFloats values = rotates ? floats(sampler["output"]) : nullptr;
    if (!values || values->components != 4) return;
    const bool cubic = sampler["interpolation"].text() == "CUBICSPLINE";
    std::size_t bad = 0;
    for (std::size_t i = cubic ? 1 : 0; i < values->count(); i += cubic ? 3 : 1) {
      const float* q = (*values)[i];
      const float square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
      bad += !(std::fabs(square - 1) < 0.05f);
    }
    warn_of(bad, pointer + "/output", "of its rotations are not of unit length");
  }

  const Context& context_;
  const JsonValue& root_;
  Buffers& buffers_;
  Accessors& accessors_;
};

}  // namespace

void check_contents(const Context& context, Buffers& buffers, Accessors& accessors,
                    const std::vector<PlacedNode>& nodes, const std::set<std::uint32_t>& images) {
  ContentChecker checker(context, buffers, accessors);
  checker.meshes(nodes);
  checker.animations();
  checker.skins();
  checker.accessors();
  checker.images(images, context.builder.is_empty());
}

}  // namespace dapple::gltf
