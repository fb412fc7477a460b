#include "import/assimp/nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "import/assimp/meshes.h"
#include "math/functions.h"
#include "scene/validate.h"

namespace dapple::assimp {
namespace {

Transformd transform_of(const aiMatrix4x4& m) {
  Transformd t;
  for (unsigned i = 0; i < 3; ++i) {
    for (unsigned j = 0; j < 4; ++j) t.rows[i][j] = double(m[i][j]);
  }
  return t;
}

bool is_usable(const Transformd& t) {
  for (const auto& row : t.rows) {
    for (const double value : row) {
      if (!(std::fabs(value) <= 1e18)) return false;
    }
  }
  return true;
}

Vec3d vec(const aiVector3D& v) { return {double(v.x), double(v.y), double(v.z)}; }
Vec3f single(const Vec3d& v) { return Vec3f(v); }

constexpr double kDegrees = 57.29577951308232;

// The angle whose half has `factor` times the tangent that half of `degrees` has.
double scaled_angle(double degrees, double factor) {
  const auto tangent = [](double half) {
    const auto [s, c] = sin_cos_turns(half / 360);
    return s / c;
  };
  const double wanted = factor * tangent(0.5 * degrees);
  double low = 0, high = 89.9;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (tangent(middle) < wanted ? low : high) = middle;
  }
  return low + high;
}

class NodeWalker {
 public:
  NodeWalker(const aiScene& scene, const std::vector<MaterialId>& materials, ModelImport& import)
      : scene_(scene), materials_(materials), import_(import) {
    uses_.resize(scene.mNumMeshes);
    prototypes_.resize(scene.mNumMeshes);
  }

  Status walk() {
    if (scene_.mRootNode == nullptr) return {};
    std::vector<Visit> stack = {{scene_.mRootNode, {}}};
    while (!stack.empty()) {
      const Visit visit = stack.back();
      stack.pop_back();
      if (visits_.size() == kMaxNodes) return fail(Errc::bad_data, "", "too many nodes");
      const Transformd to_world = visit.parent * transform_of(visit.node->mTransformation);
      visits_.push_back({visit.node, to_world});
      for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) ++uses_[visit.node->mMeshes[i]];
      for (unsigned i = visit.node->mNumChildren; i-- > 0;) {
        stack.push_back({visit.node->mChildren[i], to_world});
      }
    }
    for (const Visit& visit : visits_) {
      if (auto added = add_node(*visit.node, visit.parent); !added) return added;
    }
    add_lights();
    add_cameras();
    return {};
  }

 private:
  // A node with the transformation of its parent, later with its own to the world.
  struct Visit {
    const aiNode* node;
    Transformd parent;
  };

  Status add_node(const aiNode& node, const Transformd& to_world) {
    to_world_.emplace(node.mName.C_Str(), to_world);
    if (node.mNumMeshes > 0 && !(is_usable(to_world) && determinant(to_world) != 0)) {
      import_.log().warn(
          fmt::format("{}: the node '{:.60}' has no usable transformation and is "
                      "left out",
                      import_.path(), node.mName.C_Str()));
      return {};
    }
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (auto added = add_mesh(node.mMeshes[i], to_world); !added) return added;
    }
    return {};
  }

  Status add_mesh(unsigned index, const Transformd& to_world) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    const MaterialId material = materials_[mesh.mMaterialIndex];
    if (uses_[index] == 1) {
      MeshData data = mesh_of(mesh, material);
      move(to_world, data);
      add_points_and_lines(mesh, to_world, material, import_.builder());
      return import_.builder().add_mesh(data);
    }
    add_points_and_lines(mesh, to_world, material, import_.builder());
    if (!prototypes_[index]) {
      const auto prototype = import_.builder().add_prototype(mesh_of(mesh, material));
      if (!prototype) return tl::unexpected(prototype.error());
      prototypes_[index] = *prototype;
    }
    if (*prototypes_[index] == kNoPrototype) return {};
    Transformf single_transform;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) {
        single_transform.rows[i][j] = static_cast<float>(to_world.rows[i][j]);
      }
    }
    if (!is_valid(single_transform)) {
      import_.log().warn(fmt::format(
          "{}: an instance is left out: its transformation is flat or too large", import_.path()));
      return {};
    }
    return import_.builder().add_instance(*prototypes_[index], single_transform);
  }

  std::optional<Transformd> world_of(const aiString& node) const {
    const auto found = to_world_.find(node.C_Str());
    if (found == to_world_.end() || !is_usable(found->second)) return std::nullopt;
    return found->second;
  }

  void add_lights() {
    for (unsigned i = 0; i < scene_.mNumLights; ++i) {
      const auto light = light_of(*scene_.mLights[i]);
      if (light) {
        import_.builder().add_light(*light);
      } else {
        import_.log().warn(fmt::format("{}: the light '{:.60}' is of a kind that is left out",
                                       import_.path(), scene_.mLights[i]->mName.C_Str()));
      }
    }
  }

  // Lights of the real world grow weak with the square of the distance; others are left out.
  std::optional<Light> light_of(const aiLight& from) const {
    const auto to_world = world_of(from.mName);
    if (!to_world) return std::nullopt;
    Light light;
    light.kind = from.mType == aiLightSource_POINT  ? LightKind::point
                 : from.mType == aiLightSource_SPOT ? LightKind::spot
                                                    : LightKind::directional;
    const bool known = from.mType == aiLightSource_POINT || from.mType == aiLightSource_SPOT ||
                       from.mType == aiLightSource_DIRECTIONAL;
    const bool fades = light.kind == LightKind::directional || from.mAttenuationQuadratic > 0;
    if (!known || !fades) return std::nullopt;
    light.intensity = {from.mColorDiffuse.r, from.mColorDiffuse.g, from.mColorDiffuse.b};
    if (light.kind != LightKind::directional) {
      light.intensity = light.intensity / from.mAttenuationQuadratic;
    }
    light.position = single(to_world->point(vec(from.mPosition)));
    const Vec3d way = to_world->vector(vec(from.mDirection));
    if (light.kind != LightKind::point) {
      if (!(length(way) > 0)) return std::nullopt;
      light.direction = single(normalize(way));
    }
    light.outer_angle = std::clamp(0.5f * from.mAngleOuterCone, 0.001f, 1.5707f);
    light.inner_angle = std::clamp(0.5f * from.mAngleInnerCone, 0.0f, light.outer_angle);
    const bool finite = is_finite(light.intensity) && is_finite(light.position) &&
                        light.intensity.x >= 0 && light.intensity.y >= 0 && light.intensity.z >= 0;
    return finite ? std::optional(light) : std::nullopt;
  }

  void add_cameras() {
    for (unsigned i = 0; i < scene_.mNumCameras; ++i) {
      const aiCamera& from = *scene_.mCameras[i];
      const auto to_world = world_of(from.mName);
      if (!to_world) continue;
      Camera camera;
      camera.aperture = 0;
      camera.look_from = to_world->point(vec(from.mPosition));
      const Vec3d way = to_world->vector(vec(from.mLookAt)), up = to_world->vector(vec(from.mUp));
      if (!(length(cross(way, up)) > 0)) continue;
      camera.look_at = camera.look_from + normalize(way);
      camera.up = normalize(up);
      const double aspect = from.mAspect > 0 ? double(from.mAspect) : 4.0 / 3;
      const double across = double(from.mHorizontalFOV) * kDegrees;
      camera.vertical_fov = across > 1 && across < 179 ? scaled_angle(across, 1 / aspect) : 45;
      import_.builder().add_camera(from.mName.C_Str(), camera, double(from.mAspect));
    }
  }

  const aiScene& scene_;
  const std::vector<MaterialId>& materials_;
  ModelImport& import_;
  std::vector<Visit> visits_;
  std::vector<unsigned> uses_;  // of each mesh
  std::vector<std::optional<std::uint32_t>> prototypes_;
  std::map<std::string, Transformd> to_world_;  // by the names of nodes
};

}  // namespace

Status add_nodes(const aiScene& scene, const std::vector<MaterialId>& materials,
                 ModelImport& import) {
  return NodeWalker(scene, materials, import).walk();
}

}  // namespace dapple::assimp
