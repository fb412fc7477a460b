// Meshes, put into the scene wherever nodes place them.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/materials.h"
#include "import/gltf/nodes.h"
#include "import/gltf/primitive.h"
#include "import/mesh_data.h"

namespace dapple::gltf {

// A mesh that one node shows becomes triangles of the world; one that several show in the same
// shape becomes a prototype with instances. Points and lines always become spheres and cylinders.
class Meshes {
 public:
  Meshes(const Context& context, Accessors& accessors, Materials& materials)
      : context_(context), accessors_(accessors), materials_(materials) {}

  // `everywhere` is where every node of the file stands, for the joints of skins.
  [[nodiscard]] Status add(const std::vector<PlacedNode>& nodes, const std::vector<NodePose>& poses,
                           const std::vector<Transformd>& everywhere);

 private:
  struct Placement {
    std::uint32_t node = 0;
    std::uint32_t mesh = 0;
    std::vector<double> weights;
    std::vector<Transformd> to_world;  // several by EXT_mesh_gpu_instancing
    std::vector<Transformd> joints;    // not empty: skinned, to_world does not count
  };
  using Shape = std::pair<std::uint32_t, std::vector<double>>;  // a mesh and its weights
  struct LoadedPrimitive {
    Primitive primitive;
    LayeredMaterial material;
  };
  struct LoadedMesh {
    std::uint32_t index = 0;
    std::vector<LoadedPrimitive> primitives;
  };

  [[nodiscard]] Expected<Placement> placement(const PlacedNode& node, const NodePose& pose,
                                              const std::vector<Transformd>& everywhere);
  // Memory of which what stands at `pointer` wants count * size bytes.
  [[nodiscard]] Status take(std::uint64_t count, std::uint64_t size, const std::string& pointer);
  std::size_t custom_count(const JsonValue& attributes) const;
  [[nodiscard]] Expected<std::vector<Transformd>> gpu_instances(const JsonValue& node,
                                                                const std::string& pointer);
  [[nodiscard]] Expected<std::vector<Transformd>> joints_of(
      const JsonValue& node, const std::string& pointer, const std::vector<Transformd>& everywhere);
  [[nodiscard]] Expected<LoadedMesh> load(std::uint32_t mesh);
  [[nodiscard]] Status add_baked(const LoadedMesh& mesh, const Placement& placement,
                                 const Transformd& to_world);
  [[nodiscard]] Status add_shared(const LoadedMesh& mesh,
                                  const std::vector<const Placement*>& placements);

  const Context& context_;
  Accessors& accessors_;
  Materials& materials_;
};

}  // namespace dapple::gltf
