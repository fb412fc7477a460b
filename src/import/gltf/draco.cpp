#include "import/gltf/draco.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

namespace dapple::gltf {
namespace {

class DecodedMesh : public DracoSource {
 public:
  DecodedMesh(std::unique_ptr<draco::Mesh> mesh, Accessors& accessors, const Context& context,
              const JsonValue& ids, const JsonValue& names)
      : mesh_(std::move(mesh)),
        rest_(accessors, names),
        context_(context),
        ids_(ids),
        names_(names) {}

  Expected<SharedFloats> floats(const std::string& name) override {
    if (!ids_.has(name)) return rest_.floats(name);
    auto elements = convert<float>(name);
    if (!elements) return tl::unexpected(elements.error());
    return std::make_shared<const FloatElements>(std::move(*elements));
  }

  Expected<std::optional<IntegerElements>> integers(const std::string& name) override {
    if (!ids_.has(name)) return rest_.integers(name);
    auto elements = convert<std::uint32_t>(name);
    if (!elements) return tl::unexpected(elements.error());
    return std::optional<IntegerElements>(std::move(*elements));
  }

  std::vector<std::uint32_t> take_indices() override {
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t{mesh_->num_faces()} * 3);
    for (draco::FaceIndex face(0); face < mesh_->num_faces(); ++face) {
      for (const draco::PointIndex& point : mesh_->face(face)) indices.push_back(point.value());
    }
    return indices;
  }

 private:
  // Whether integers are normalised is the accessor's to say, not the stream's.
  template <class T>
  Expected<Elements<T>> convert(const std::string& name) {
    const auto id = ids_[name].index();
    const draco::PointAttribute* attribute = id ? mesh_->GetAttributeByUniqueId(*id) : nullptr;
    const std::string place = "extensions/KHR_draco_mesh_compression/attributes/" + name;
    if (attribute == nullptr) {
      return fail(Errc::bad_data, place, "the stream has no attribute of that number");
    }
    const auto accessor = names_[name].index();
    const JsonValue& json = context_.document["accessors"][accessor.value_or(0xffffffffu)];
    const std::size_t components = attribute->num_components();
    if (components != component_count(json["type"].text())) {
      return fail(Errc::bad_data, place, "its accessor has another type");
    }
    ByteBudget& budget = context_.builder.budget();
    if (auto taken = budget.take(mesh_->num_points(), components * sizeof(T), place); !taken) {
      return tl::unexpected(taken.error());
    }
    const float scale = normalising_scale(*attribute, json["normalized"].bool_or(false));
    Elements<T> elements{components, std::vector<T>(mesh_->num_points() * components)};
    for (draco::PointIndex point(0); point < mesh_->num_points(); ++point) {
      T* to = elements.values.data() + point.value() * components;
      const auto value = attribute->mapped_index(point);
      if (value.value() >= attribute->size() ||
          !attribute->ConvertValue<T>(value, static_cast<std::int8_t>(components), to)) {
        return fail(Errc::bad_data, place, "the stream's values are of the wrong type");
      }
      for (std::size_t i = 0; i < components; ++i) normalise(to[i], scale);
    }
    return elements;
  }

  static void normalise(float& value, float scale) {
    if (scale != 1) value = std::max(value / scale, -1.0f);
  }
  static void normalise(std::uint32_t&, float) {}

  static float normalising_scale(const draco::PointAttribute& attribute, bool normalised) {
    if (!normalised || attribute.normalized()) return 1;  // draco itself divides in that case
    switch (attribute.data_type()) {
      case draco::DT_INT8:
        return 127;
      case draco::DT_UINT8:
        return 255;
      case draco::DT_INT16:
        return 32767;
      case draco::DT_UINT16:
        return 65535;
      default:
        return 1;
    }
  }

  std::unique_ptr<draco::Mesh> mesh_;
  AccessorSource rest_;
  const Context& context_;
  const JsonValue& ids_;
  const JsonValue& names_;
};

}  // namespace

Expected<std::unique_ptr<DracoSource>> DracoSource::decode(Accessors& accessors,
                                                           const Context& context,
                                                           const JsonValue& draco,
                                                           const JsonValue& names) {
  const std::string place = "extensions/KHR_draco_mesh_compression";
  const auto view = draco["bufferView"].index();
  if (!view)
    return fail(Errc::bad_data, place + "/bufferView", "is not the number of a buffer view");
  const auto bytes = accessors.buffers().view(*view);
  if (!bytes) return tl::unexpected(bytes.error());
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) {
    return fail(Errc::bad_data, place,
                std::string("damaged Draco stream: ") + mesh.status().error_msg());
  }
  return std::make_unique<DecodedMesh>(std::move(mesh).value(), accessors, context,
                                       draco["attributes"], names);
}

}  // namespace dapple::gltf
