// Where nodes want their meshes: once, by instancing attributes, or bound to joints.
#include <fmt/format.h>

#include "import/gltf/attributes.h"
#include "import/gltf/meshes.h"

namespace dapple::gltf {
namespace {

constexpr const char* kGpuInstancing = "EXT_mesh_gpu_instancing";

Transformd matrix_of(const float* columns) {
  Transformd m;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) m.rows[row][column] = columns[column * 4 + row];
  }
  return m;
}

std::vector<double> weights_of(const JsonValue& mesh, const NodePose& pose) {
  if (!pose.weights.empty()) return pose.weights;
  std::vector<double> weights;
  for (const JsonValue& weight : mesh["weights"].items()) weights.push_back(weight.number_or(0));
  return weights;
}

}  // namespace

Status Meshes::take(std::uint64_t count, std::uint64_t size, const std::string& pointer) {
  const Status taken = context_.builder.budget().take(count, size, pointer);
  return taken ? taken : context_.document.error(pointer, taken.error().message);
}

// How many instances attributes of other names than those of transforms tell; 0: there are none.
std::size_t Meshes::custom_count(const JsonValue& attributes) const {
  for (const JsonMember& member : attributes.members()) {
    const auto accessor = member.value.index();
    if (!member.key.starts_with('_') || !accessor) continue;
    return context_.document["accessors"][*accessor]["count"].count().value_or(0);
  }
  return 0;
}

Expected<std::vector<Transformd>> Meshes::gpu_instances(const JsonValue& node,
                                                        const std::string& pointer) {
  const std::string place = pointer + "/extensions/" + kGpuInstancing;
  AccessorSource source(accessors_, node["extensions"][kGpuInstancing]["attributes"]);
  const auto translations = source.floats("TRANSLATION");
  const auto rotations = source.floats("ROTATION");
  const auto scales = source.floats("SCALE");
  if (!translations) return tl::unexpected(translations.error());
  if (!rotations) return tl::unexpected(rotations.error());
  if (!scales) return tl::unexpected(scales.error());
  std::size_t count = custom_count(node["extensions"][kGpuInstancing]["attributes"]);
  for (const SharedFloats& elements : {*translations, *rotations, *scales}) {
    if (elements == nullptr) continue;
    const std::size_t components = elements == *rotations ? 4 : 3;
    if (elements->components != components || (count != 0 && elements->count() != count)) {
      return context_.document.error(place, "its attributes differ in type or count");
    }
    count = elements->count();
  }
  if (auto taken = take(count, sizeof(Transformd), pointer); !taken) {
    return tl::unexpected(taken.error());
  }
  std::vector<Transformd> transforms;
  transforms.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    NodePose pose;
    for (int k = 0; k < 3; ++k) {
      if (*translations) pose.translation[k] = (**translations)[i][k];
      if (*scales) pose.scale[k] = (**scales)[i][k];
    }
    for (int k = 0; k < 4 && *rotations; ++k) pose.rotation[k] = (**rotations)[i][k];
    transforms.push_back(transform_of(pose));
  }
  return transforms;
}

Expected<std::vector<Transformd>> Meshes::joints_of(const JsonValue& node,
                                                    const std::string& pointer,
                                                    const std::vector<Transformd>& everywhere) {
  const Document& document = context_.document;
  const auto index = node["skin"].index();
  const JsonValue& skin = document["skins"][index.value_or(0xffffffffu)];
  if (skin.is_null()) return document.error(pointer + "/skin", "the skin does not exist");
  const std::string place = fmt::format("/skins/{}", *index);
  SharedFloats bind;
  if (skin.has("inverseBindMatrices")) {
    const auto matrices = accessors_.floats(skin["inverseBindMatrices"].index().value_or(~0u));
    if (!matrices) return tl::unexpected(matrices.error());
    bind = *matrices;
    if (bind->components != 16 || bind->count() < skin["joints"].size()) {
      return document.error(place + "/inverseBindMatrices", "is not a matrix for each joint");
    }
  }
  if (auto taken = take(skin["joints"].size(), sizeof(Transformd), pointer); !taken) {
    return tl::unexpected(taken.error());
  }
  std::vector<Transformd> joints;
  for (std::size_t i = 0; i < skin["joints"].size(); ++i) {
    const auto joint = skin["joints"][i].index();
    if (!joint || *joint >= everywhere.size()) {
      return document.error(place + "/joints", "a joint does not exist");
    }
    joints.push_back(bind == nullptr ? everywhere[*joint]
                                     : everywhere[*joint] * matrix_of((*bind)[i]));
  }
  if (joints.empty()) return document.error(place + "/joints", "there are no joints");
  return joints;
}

Expected<Meshes::Placement> Meshes::placement(const PlacedNode& node, const NodePose& pose,
                                              const std::vector<Transformd>& everywhere) {
  const JsonValue& json = context_.document["nodes"][node.index];
  const std::string pointer = fmt::format("/nodes/{}", node.index);
  Placement placement;
  placement.node = node.index;
  placement.mesh = json["mesh"].index().value_or(0xffffffffu);
  const JsonValue& mesh = context_.document["meshes"][placement.mesh];
  if (mesh.is_null()) return context_.document.error(pointer + "/mesh", "the mesh does not exist");
  placement.weights = weights_of(mesh, pose);
  if (auto taken = take(placement.weights.size(), sizeof(double), pointer); !taken) {
    return tl::unexpected(taken.error());
  }
  placement.to_world = {node.to_world};
  if (json.has("skin")) {
    auto joints = joints_of(json, pointer, everywhere);
    if (!joints) return tl::unexpected(joints.error());
    placement.joints = std::move(*joints);
  } else if (json["extensions"][kGpuInstancing].is_object()) {
    auto copies = gpu_instances(json, pointer);
    if (!copies) return tl::unexpected(copies.error());
    for (Transformd& copy : *copies) copy = node.to_world * copy;
    placement.to_world = std::move(*copies);
  }
  return placement;
}

}  // namespace dapple::gltf
