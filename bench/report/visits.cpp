#include "report/visits.h"

#include "accel/leaf_list.h"
#include "accel/wide_accel.h"
#include "parallel/parallel.h"
#include "report/csv_file.h"
#include "report/opened_scene.h"
#include "report/visiting_accel.h"

namespace dapple::bench {
namespace {

struct Picture {
  const char* scene;
  int side, samples;
};

// Those of the cache simulation, so that its counts can be divided by these rays.
constexpr Picture kPictures[] = {
    {"nice", 48, 4},  {"nice", 48, 8},  {"rgbbox", 48, 4},         {"rgbbox", 48, 8},
    {"irreg", 48, 4}, {"irreg", 48, 8}, {"spheres:200000", 12, 4}, {"spheres:200000", 12, 8},
};

Status measure(const Picture& p, CsvFile& csv) {
  const auto scene = OpenedScene::open(p.scene);
  if (!scene) return tl::unexpected(scene.error());
  const WideAccel tree(scene->view());
  auto visiting = std::make_unique<VisitingAccel>(tree, tree.view());
  const VisitingAccel& visitor = *visiting;
  const PreparedScene prepared(scene->view(), std::move(visiting));
  if (auto done = render(prepared, picture(p.side, p.side, p.samples)); !done) {
    return tl::unexpected(done.error());
  }
  const VisitCounts& counts = visitor.counts();
  const auto rays = static_cast<double>(counts.rays);
  const LeafList list(scene->view());
  csv.add(p.scene, p.side, p.samples, scene->view().object_count(), counts.rays,
          digits(static_cast<double>(counts.nodes) / rays),
          digits(static_cast<double>(counts.leaves) / rays),
          digits(static_cast<double>(counts.bytes) / rays), list.bytes(), tree.stats().bytes,
          counts.distinct_bytes);
  return {};
}

}  // namespace

Status study_visits(const std::string& folder) {
  set_thread_count(1);
  CsvFile csv({"scene", "side", "samples", "objects", "rays", "nodes_per_ray", "leaves_per_ray",
               "bvh_bytes_per_ray", "ray_bytes_per_ray", "bvh_bytes", "bvh_bytes_read"});
  for (const Picture& p : kPictures) {
    if (auto status = measure(p, csv); !status) return status;
  }
  set_thread_count(0);
  return csv.write(folder + "/visits.csv");
}

}  // namespace dapple::bench
