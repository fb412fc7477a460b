#include "import/gltf/gltf.h"

#include <fmt/format.h>

#include "import/gltf/animation.h"
#include "import/gltf/check.h"
#include "import/gltf/lights_cameras.h"
#include "import/gltf/meshes.h"

namespace dapple {
namespace gltf {
namespace {

void report_left_out(const Context& context) {
  const auto& left_out = context.builder.left_out();
  if (left_out.without_area > 0) {
    context.warn("",
                 fmt::format("{} triangles have no area and are left out", left_out.without_area));
  }
  if (left_out.not_finite > 0) {
    context.warn("", fmt::format("{} triangles have corners that are not finite or beyond 1e18 and "
                                 "are left out",
                                 left_out.not_finite));
  }
}

Status check(const Context& context) {
  return check_structure(context)
      .and_then([&] { return check_data(context); })
      .and_then([&] { return check_meshes(context); })
      .and_then([&] { return check_nodes(context); })
      .and_then([&] { return check_variant(context); });
}

Status fill(const Context& context) {
  auto buffers = Buffers::load(context);
  if (!buffers) return tl::unexpected(buffers.error());
  Accessors accessors(*buffers);
  std::vector<NodePose> poses = stored_poses(context.document);
  if (context.options.time) {
    const Status moved = animate(context, accessors, *context.options.time, poses);
    if (!moved) return moved;
  }
  const auto nodes = place_nodes(context, poses);
  if (!nodes) return tl::unexpected(nodes.error());
  const auto everywhere = world_transforms(context, poses);
  if (!everywhere) return tl::unexpected(everywhere.error());

  const auto textures = Textures::load(context, *buffers, materials_in_use(context, *nodes));
  if (!textures) return tl::unexpected(textures.error());
  Materials materials(context, *textures);
  const Status added = Meshes(context, accessors, materials)
                           .add(*nodes, poses, *everywhere)
                           .and_then([&] { return add_cameras(context, *nodes); })
                           .and_then([&] { return add_lights(context, *nodes); });
  if (added) check_contents(context, *buffers, accessors, *nodes, textures->images());
  return added;
}

}  // namespace
}  // namespace gltf

Expected<ImportResult> import_gltf(const std::string& path, const ImportOptions& options) {
  const auto document = gltf::Document::open(path);
  if (!document) return tl::unexpected(document.error());
  SceneBuilder builder(options.max_bytes);
  ImportLog log;
  const gltf::Context context{*document, options, builder, log};
  const Status filled = gltf::check(context).and_then([&] { return gltf::fill(context); });
  if (!filled) return tl::unexpected(filled.error());
  gltf::report_left_out(context);
  if (builder.is_empty()) context.warn("", "the scene shows nothing");
  auto scene = builder.finish(options.camera, options.point_radius);
  if (!scene) return tl::unexpected(scene.error());
  return ImportResult{std::move(*scene), log.take(), {std::nullopt, builder.camera_aspects()}};
}

}  // namespace dapple
