#include "import/gltf/nodes.h"

#include <fmt/format.h>

#include <charconv>

#include "import/limits.h"

namespace dapple::gltf {
namespace {

constexpr std::uint32_t kNoParent = 0xffffffffu;

std::string node_pointer(std::size_t index) { return fmt::format("/nodes/{}", index); }

Transformd matrix_of(const JsonValue& columns) {
  Transformd m;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      m.rows[row][column] = columns[column * 4 + row].number_or(0);
    }
  }
  return m;
}

// The parent of every node, once there are neither cycles nor nodes with two parents.
Expected<std::vector<std::uint32_t>> parents_of(const Document& document) {
  const JsonValue& nodes = document["nodes"];
  if (nodes.size() > kMaxNodes) return document.error("/nodes", "too many nodes");
  std::vector<std::uint32_t> parents(nodes.size(), kNoParent);
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    for (const JsonValue& child : nodes[i]["children"].items()) {
      const auto index = child.index();
      if (!index || *index >= parents.size()) {
        return document.error(node_pointer(i) + "/children", "a child does not exist");
      }
      if (parents[*index] != kNoParent) {
        return document.error(
            node_pointer(*index),
            fmt::format("it is a child of both node {} and node {}", parents[*index], i));
      }
      parents[*index] = i;
    }
  }
  return parents;
}

// Every node once, parents before children. With one parent each, a node that is not reached from
// the roots is part of a cycle or hangs below one.
Expected<std::vector<std::uint32_t>> parents_first(const Document& document,
                                                   const std::vector<std::uint32_t>& parents) {
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> depth(parents.size(), 0);
  for (std::uint32_t i = 0; i < parents.size(); ++i) {
    if (parents[i] == kNoParent) order.push_back(i);
  }
  for (std::size_t next = 0; next < order.size(); ++next) {
    const std::uint32_t node = order[next];
    for (const JsonValue& child : document["nodes"][node]["children"].items()) {
      const std::uint32_t index = *child.index();
      depth[index] = depth[node] + 1;
      if (depth[index] > kMaxNodeDepth) return document.error(node_pointer(index), "is too deep");
      order.push_back(index);
    }
  }
  if (order.size() == parents.size()) return order;
  std::vector<bool> reached(parents.size(), false);
  for (const std::uint32_t node : order) reached[node] = true;
  std::uint32_t node = 0;
  while (reached[node]) ++node;
  for (std::size_t i = 0; i < parents.size(); ++i) node = parents[node];  // into the cycle itself
  return document.error(node_pointer(node), "the node is its own ancestor");
}

Expected<std::uint32_t> chosen_scene(const Context& context) {
  const JsonValue& scenes = context.document["scenes"];
  const std::string& wanted = context.options.scene;
  if (wanted.empty()) {
    const auto index = context.document.root().has("scene") ? context.document["scene"].index() : 0;
    if (index && *index < scenes.size()) return *index;
    return context.document.error("/scene", "the scene does not exist");
  }
  for (std::uint32_t i = 0; i < scenes.size(); ++i) {
    if (scenes[i]["name"].text() == wanted) return i;
  }
  std::uint32_t index = 0;
  const char* end = wanted.data() + wanted.size();
  const auto [stop, error] = std::from_chars(wanted.data(), end, index);
  if (error == std::errc() && stop == end && index < scenes.size()) return index;
  std::string names;
  for (const JsonValue& scene : scenes.items()) {
    const std::string name(scene["name"].text());
    names += names.empty() ? "" : ", ";
    names += name.empty() ? "one without a name" : '"' + name + '"';
  }
  return fail(Errc::usage, context.document.place(""),
              fmt::format("there is no scene \"{}\"; the {} of the file: {}", wanted, scenes.size(),
                          names.empty() ? "none" : names));
}

// The roots to start from: those of the chosen scene or, in a file without scenes, all.
Expected<std::vector<bool>> visible_roots(const Context& context,
                                          const std::vector<std::uint32_t>& parents) {
  std::vector<bool> visible(parents.size(), false);
  if (context.document["scenes"].size() == 0 && context.options.scene.empty()) {
    for (std::size_t i = 0; i < parents.size(); ++i) visible[i] = parents[i] == kNoParent;
    return visible;
  }
  const auto scene = chosen_scene(context);
  if (!scene) return tl::unexpected(scene.error());
  const std::string pointer = fmt::format("/scenes/{}/nodes", *scene);
  for (const JsonValue& root : context.document["scenes"][*scene]["nodes"].items()) {
    const auto index = root.index();
    if (!index || *index >= parents.size()) {
      return context.document.error(pointer, "a node does not exist");
    }
    if (parents[*index] != kNoParent) {
      return context.document.error(pointer, fmt::format("node {} is not a root", *index));
    }
    visible[*index] = true;
  }
  return visible;
}

bool is_shown(const JsonValue& node) {
  return node["extensions"]["KHR_node_visibility"]["visible"].bool_or(true);
}

Transformd local_transform(const JsonValue& node, const NodePose& pose) {
  return node.has("matrix") ? matrix_of(node["matrix"]) : transform_of(pose);
}

}  // namespace

std::vector<NodePose> stored_poses(const Document& document) {
  std::vector<NodePose> poses;
  for (const JsonValue& node : document["nodes"].items()) {
    NodePose& pose = poses.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const int axis = static_cast<int>(i);
      pose.translation[axis] = node["translation"][i].number_or(0);
      pose.scale[axis] = node["scale"][i].number_or(1);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      pose.rotation[i] = node["rotation"][i].number_or(i == 3 ? 1 : 0);
    }
    for (const JsonValue& weight : node["weights"].items()) {
      pose.weights.push_back(weight.number_or(0));
    }
  }
  return poses;
}

Transformd transform_of(const NodePose& pose) {
  double q[4];
  double norm = 0;
  for (const double c : pose.rotation) norm += c * c;
  norm = std::sqrt(norm);
  for (int i = 0; i < 4; ++i) q[i] = norm > 0 ? pose.rotation[i] / norm : (i == 3 ? 1.0 : 0.0);
  const auto [x, y, z, w] = q;
  const double rotation[3][3] = {
      {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
      {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
      {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  Transformd m;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m.rows[row][column] = rotation[row][column] * pose.scale[column];
    }
    m.rows[row][3] = pose.translation[row];
  }
  return m;
}

Expected<std::vector<PlacedNode>> place_nodes(const Context& context,
                                              const std::vector<NodePose>& poses) {
  const auto parents = parents_of(context.document);
  if (!parents) return tl::unexpected(parents.error());
  const auto order = parents_first(context.document, *parents);
  if (!order) return tl::unexpected(order.error());
  auto visible = visible_roots(context, *parents);
  if (!visible) return tl::unexpected(visible.error());
  const JsonValue& nodes = context.document["nodes"];
  std::vector<Transformd> to_world(parents->size());
  std::vector<PlacedNode> placed;
  for (const std::uint32_t i : *order) {
    const std::uint32_t parent = (*parents)[i];
    if (parent != kNoParent && (*visible)[parent]) (*visible)[i] = true;
    if (!is_shown(nodes[i])) (*visible)[i] = false;
    if (!(*visible)[i]) continue;
    const Transformd local = local_transform(nodes[i], poses[i]);
    to_world[i] = parent == kNoParent ? local : to_world[parent] * local;
    placed.push_back({i, to_world[i]});
  }
  return placed;
}

Expected<std::vector<Transformd>> world_transforms(const Context& context,
                                                   const std::vector<NodePose>& poses) {
  const auto parents = parents_of(context.document);
  if (!parents) return tl::unexpected(parents.error());
  const auto order = parents_first(context.document, *parents);
  if (!order) return tl::unexpected(order.error());
  std::vector<Transformd> to_world(parents->size());
  for (const std::uint32_t i : *order) {
    const std::uint32_t parent = (*parents)[i];
    const Transformd local = local_transform(context.document["nodes"][i], poses[i]);
    to_world[i] = parent == kNoParent ? local : to_world[parent] * local;
  }
  return to_world;
}

}  // namespace dapple::gltf
