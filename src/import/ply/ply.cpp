#include "import/ply/ply.h"

#include <fmt/format.h>

#include "import/default_material.h"
#include "import/model_import.h"
#include "import/ply/model.h"
#include "import/points.h"

namespace dapple {
namespace {

Expected<LayeredMaterial> material_of(const ply::Model& model, ModelImport& import) {
  LayeredMaterial material = default_material();
  if (!model.mesh.vertices.colours.empty()) material.base_colour = {1, 1, 1};
  if (model.texture_file.empty() || model.mesh.vertices.uvs[0].empty()) return material;
  const auto texture = import.texture(model.texture_file, import.path());
  if (!texture) return tl::unexpected(texture.error());
  material.base_colour = {1, 1, 1};
  material.map(MapUse::base_colour).texture = *texture;
  return material;
}

Status add_mesh(ply::Model& model, ModelImport& import) {
  const auto material = material_of(model, import);
  if (!material) return tl::unexpected(material.error());
  MeshData& mesh = model.mesh;
  mesh.materials.assign(mesh.triangles.size(), import.builder().add_material(*material));
  return import.builder().add_mesh(mesh);
}

Status add_cloud(const ply::Model& model, ModelImport& import) {
  const Vertices& vertices = model.mesh.vertices;
  const double asked = import.options().point_radius;
  PointCloud cloud{vertices.positions, vertices.colours, {}, asked};
  if (asked <= 0) {
    cloud.radii = model.radii;
    cloud.radius = default_point_radius(vertices.positions, vertices.positions.size());
  }
  const auto left_out = add_points(cloud, import.builder());
  if (!left_out) return tl::unexpected(left_out.error());
  if (*left_out > 0) {
    import.log().warn(fmt::format(
        "{}: {} points whose position or radius is not finite or too large are left out",
        import.path(), *left_out));
  }
  return {};
}

}  // namespace

Expected<ImportResult> import_ply(const std::string& path, const ImportOptions& options) {
  auto import = ModelImport::open(path, options);
  if (!import) return tl::unexpected(import.error());
  auto model = ply::read(import->bytes(), path, options.keep_going);
  if (!model) return tl::unexpected(model.error());
  for (const std::string& what : model->ignored) {
    import->log().warn(fmt::format("{}: {} is not understood", path, what));
  }
  if (model->skipped_faces > 0) {
    import->log().warn(fmt::format("{}: {} faces with fewer than three corners are left out", path,
                                   model->skipped_faces));
  }
  if (model->broken_faces > 0) {
    import->log().warn(fmt::format("{}: {} faces with indices of nothing are left out ({})", path,
                                   model->broken_faces, model->broken_reason));
  }
  auto added = model->is_cloud() ? add_cloud(*model, *import) : add_mesh(*model, *import);
  if (!added) {
    const Error& error = added.error();
    return fail(error.code, error.place.starts_with(path) ? error.place : path, error.message);
  }
  return import->finish();
}

}  // namespace dapple
