#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/check.h"

namespace dapple::gltf {
namespace {

// The trees that nodes form. Nodes of cycles, which are an error elsewhere, are roots of their own.
struct Forest {
  std::vector<std::uint32_t> root;        // of each node's tree
  std::vector<std::uint32_t> begin, end;  // a node's number in a walk, and one past its last heir

  explicit Forest(const JsonValue& nodes) : root(nodes.size()), begin(root), end(root) {
    std::vector<bool> is_child(nodes.size(), false);
    for (const JsonValue& node : nodes.items()) {
      for (const JsonValue& child : node["children"].items()) is_child[*child.index()] = true;
    }
    std::iota(root.begin(), root.end(), 0u);
    std::vector<bool> visited(nodes.size(), false);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (!is_child[i]) walk(nodes, i, visited);
    }
  }

  bool is_below(std::uint32_t node, std::uint32_t above) const {
    return begin[above] <= begin[node] && begin[node] < end[above];
  }

 private:
  void walk(const JsonValue& nodes, std::uint32_t top, std::vector<bool>& visited) {
    struct Step {
      std::uint32_t node;
      std::size_t child;
    };
    std::vector<Step> path = {{top, 0}};
    while (!path.empty()) {
      auto& [node, child] = path.back();
      if (child == 0) {
        visited[node] = true;
        root[node] = top;
        begin[node] = count_++;
      }
      const JsonValue& children = nodes[node]["children"];
      if (child == children.size()) {
        end[node] = count_;
        path.pop_back();
        continue;
      }
      const std::uint32_t next = *children[child++].index();
      if (!visited[next]) path.push_back({next, 0});
    }
  }

  std::uint32_t count_ = 1;
};

class NodeChecker {
 public:
  explicit NodeChecker(const Context& context)
      : context_(context), root_(context.document.root()) {}

  Status check() {
    const JsonValue& nodes = root_["nodes"];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      pointer_ = fmt::format("/nodes/{}", i);
      node(nodes[i]);
    }
    check_roots();
    const JsonValue& skins = root_["skins"];
    for (std::size_t i = 0; i < skins.size(); ++i) {
      pointer_ = fmt::format("/skins/{}", i);
      if (auto ok = skin(skins[i]); !ok) return ok;
    }
    const JsonValue& animations = root_["animations"];
    for (std::size_t i = 0; i < animations.size(); ++i) {
      pointer_ = fmt::format("/animations/{}", i);
      if (auto ok = animation(animations[i]); !ok) return ok;
    }
    const JsonValue& lights = root_["extensions"]["KHR_lights_punctual"]["lights"];
    for (std::size_t i = 0; i < lights.size(); ++i) {
      pointer_ = fmt::format("/extensions/KHR_lights_punctual/lights/{}", i);
      if (auto ok = light(lights[i]); !ok) return ok;
    }
    return {};
  }

 private:
  [[nodiscard]] tl::unexpected<Error> error(const std::string& below, std::string message) const {
    return context_.document.error(pointer_ + below, std::move(message));
  }
  void warn_if(bool wrong, const std::string& below, const std::string& message) const {
    if (wrong) context_.warn(pointer_ + below, message);
  }
  const JsonValue& referred(const char* array, const JsonValue& number) const {
    return root_[array][number.index().value_or(0xffffffffu)];
  }

  void node(const JsonValue& n) const {
    const bool trs = n.has("translation") || n.has("rotation") || n.has("scale");
    warn_if(trs && n.has("matrix"), "", "has both a matrix, which counts, and parts of one");
    warn_if(n.has("skin") && !n.has("mesh"), "/skin", "stands without a mesh");
    double norm = 0;
    for (const JsonValue& c : n["rotation"].items()) norm += c.number_or(0) * c.number_or(0);
    warn_if(n.has("rotation") && std::fabs(norm - 1) > 1e-3, "/rotation", "is not of unit length");
    warn_if(n.has("matrix") && !is_decomposable(n["matrix"]), "/matrix",
            "is not made of a translation, rotation and scale");
    const JsonValue& first = referred("meshes", n["mesh"])["primitives"][std::size_t{0}];
    warn_if(n.has("weights") && !n.has("mesh"), "/weights", "stand without a mesh");
    warn_if(n.has("weights") && n["weights"].size() != first["targets"].size(), "/weights",
            "differ in number from the morph targets");
    warn_if(n.has("skin") && n.has("mesh") && !first["attributes"].has("JOINTS_0"), "/skin",
            "its mesh names no joints");
  }

  static bool is_decomposable(const JsonValue& m) {
    const auto at = [&](std::size_t row, std::size_t column) {
      return m[column * 4 + row].number_or(0);
    };
    if (at(3, 0) != 0 || at(3, 1) != 0 || at(3, 2) != 0 || at(3, 3) != 1) return false;
    for (std::size_t a = 0; a < 3; ++a) {
      double across = 0, aa = 0, bb = 0;
      for (std::size_t row = 0; row < 3; ++row) {
        const double x = at(row, a), y = at(row, (a + 1) % 3);
        across += x * y;
        aa += x * x;
        bb += y * y;
      }
      if (aa == 0 || across * across > 1e-6 * aa * bb) return false;
    }
    return true;
  }

  void check_roots() {
    std::set<std::uint32_t> children;
    for (const JsonValue& n : root_["nodes"].items()) {
      for (const JsonValue& child : n["children"].items()) {
        children.insert(child.index().value_or(0));
      }
    }
    const JsonValue& scenes = root_["scenes"];
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      pointer_ = fmt::format("/scenes/{}", i);
      for (const JsonValue& root : scenes[i]["nodes"].items()) {
        warn_if(children.contains(root.index().value_or(0xffffffffu)), "/nodes",
                "names a node that is not a root");
      }
    }
  }

  Status skin(const JsonValue& s) const {
    check_trees(s);
    const JsonValue& matrices = referred("accessors", s["inverseBindMatrices"]);
    if (!s.has("inverseBindMatrices")) return {};
    if (matrices["type"].text() != "MAT4" || matrices["componentType"].count() != 5126u) {
      return error("/inverseBindMatrices", "is not of MAT4 of floats");
    }
    if (matrices["count"].count().value_or(0) < s["joints"].size()) {
      return error("/inverseBindMatrices", "has fewer matrices than there are joints");
    }
    warn_if(referred("bufferViews", matrices["bufferView"]).has("byteStride"),
            "/inverseBindMatrices", "has a stride");
    return {};
  }

  // Joints hang together in one tree, below the skeleton if the skin names one.
  void check_trees(const JsonValue& s) const {
    const auto skeleton = s["skeleton"].index();
    const JsonValue& joints = s["joints"];
    std::size_t apart = 0, outside = 0;
    for (const JsonValue& joint : joints.items()) {
      const std::uint32_t node = joint.index().value_or(0);
      apart += forest_.root[node] != forest_.root[joints[std::size_t{0}].index().value_or(0)];
      outside += skeleton && !forest_.is_below(node, *skeleton);
    }
    warn_if(apart > 0, "/joints", "have no common root");
    warn_if(outside > 0, "/skeleton", fmt::format("{} joints are not below it", outside));
  }

  Status animation(const JsonValue& a) const {
    std::set<std::pair<std::uint32_t, std::string>> targets;
    for (std::size_t i = 0; i < a["channels"].size(); ++i) {
      const JsonValue& channel = a["channels"][i];
      const std::string below = fmt::format("/channels/{}", i);
      const auto sampler = channel["sampler"].index();
      if (!sampler || *sampler >= a["samplers"].size()) {
        return error(below + "/sampler", "the sampler does not exist");
      }
      const std::string& path = channel["target"]["path"].text();
      const auto number = channel["target"]["node"].index();
      if (!number) continue;
      warn_if(!targets.insert({*number, path}).second, below, "moves what another one moves");
      const JsonValue& node = root_["nodes"][*number];
      const JsonValue& mesh = referred("meshes", node["mesh"])["primitives"][std::size_t{0}];
      warn_if(path == "weights" && mesh["targets"].size() == 0, below,
              "moves the weights of a mesh without morph targets");
      warn_if(path != "weights" && node.has("matrix"), below, "moves a node with a matrix");
      if (auto ok = track(a["samplers"][*sampler], path, mesh["targets"].size(), below); !ok) {
        return ok;
      }
    }
    return {};
  }

  Status track(const JsonValue& sampler, const std::string& path, std::size_t weights,
               const std::string& below) const {
    const JsonValue& input = referred("accessors", sampler["input"]);
    const JsonValue& output = referred("accessors", sampler["output"]);
    if (input["type"].text() != "SCALAR" || input["componentType"].count() != 5126u) {
      return error(below, "its times are not floats");
    }
    const std::size_t width = path == "rotation" ? 4 : path == "weights" ? 1 : 3;
    const bool known = width != 3 || path == "translation" || path == "scale";
    warn_if(!known, below + "/target/path", path + " is not known and is ignored");
    if (known && component_count(output["type"].text()) != width) {
      return error(below, "its values are of the wrong type for " + path);
    }
    const bool cubic = sampler["interpolation"].text() == "CUBICSPLINE";
    const std::uint64_t keys = input["count"].count().value_or(0);
    const std::uint64_t per_key = (cubic ? 3 : 1) * (path == "weights" ? weights : 1);
    if (known && per_key > 0 && output["count"].count().value_or(0) != keys * per_key) {
      return error(below, fmt::format("it has {} values for {} keys",
                                      output["count"].count().value_or(0), keys));
    }
    warn_if(cubic && keys < 2, below, "a spline has at least two keys");
    warn_if(!input.has("min") || !input.has("max"), below, "its times have no min and max");
    warn_if(referred("bufferViews", input["bufferView"]).has("byteStride") ||
                referred("bufferViews", output["bufferView"]).has("byteStride"),
            below, "its data has a stride");
    return {};
  }

  Status light(const JsonValue& l) const {
    if (l["type"].text() != "spot") return {};
    if (!l.has("spot")) return error("/spot", "is missing");
    const double inner = l["spot"]["innerConeAngle"].number_or(0);
    const double outer = l["spot"]["outerConeAngle"].number_or(0.7853981633974483);
    if (outer <= inner) return error("/spot", "outerConeAngle is not greater than innerConeAngle");
    return {};
  }

  const Context& context_;
  const JsonValue& root_;
  Forest forest_{root_["nodes"]};
  std::string pointer_;  // of the object that is being checked
};

}  // namespace

Status check_nodes(const Context& context) { return NodeChecker(context).check(); }

}  // namespace dapple::gltf
