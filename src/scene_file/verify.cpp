#include "scene_file/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <type_traits>

#include "parallel/parallel.h"
#include "scene/array_checks.h"
#include "scene/validate.h"
#include "scene/validate_instances.h"
#include "scene/validate_looks.h"
#include "scene_file/first_fault.h"
#include "scene_file/records.h"
#include "scene_file/section_hash.h"
#include "scene_file/section_table.h"
#include "scene_file/verify_bvh.h"

namespace dapple {
namespace {

// Below this many bytes waking threads costs more than they save.
constexpr std::size_t kParallelBytes = 4 * kHashChunk;

// What a rendering through the BVH does not read: leaves have all of it.
bool is_in_leaves(SectionType type) {
  return type == SectionType::spheres || type == SectionType::xy_rectangles ||
         type == SectionType::xz_rectangles || type == SectionType::yz_rectangles;
}

class Verifier {
 public:
  Verifier(const SectionTable& table, std::size_t file_size, const VerifyOptions& options)
      : table_(table), options_(options), parallel_(file_size >= kParallelBytes) {}

  Expected<VerifiedScene> run() {
    if (auto status = lay_out(); !status) return tl::unexpected(status.error());
    check_contents();
    for (const Status& status : {check_hashes(), faults_.status(), decode_small_sections()}) {
      if (!status) return tl::unexpected(status.error());
    }
    if (auto status = finish_bvh(); !status) return tl::unexpected(status.error());
    result_.shapes_verified = !skip_shapes();
    return std::move(result_);
  }

 private:
  // One piece of one section, hashed and checked while it is in the cache.
  struct Chunk {
    const SectionEntry* section;
    std::uint64_t begin;  // in the section
    std::uint64_t* hash;
  };

  bool skip_shapes() const { return options_.scope == VerifyScope::bvh_only && bvh_.has_value(); }
  bool is_skipped(const SectionEntry& section) const {
    return skip_shapes() && is_in_leaves(SectionType{section.type});
  }
  std::uint64_t offset_of_node(std::size_t node) const {
    return table_.find(SectionType::bvh_nodes)->offset + node * sizeof(WideNode);
  }
  std::uint64_t offset_of(SectionType type) const {
    const SectionEntry* entry = table_.find(type);
    return entry == nullptr ? 0 : entry->offset;
  }

  Status lay_out();
  void check_contents();
  void check_chunk(const Chunk& chunk);
  void check_piece(const SectionEntry& section, std::uint64_t begin, std::uint64_t size);
  void report(const SectionEntry& section, SceneArray array, std::size_t index);
  void report(const BvhDamage& damage);
  Status check_hashes() const;
  Status decode_small_sections();
  Status read_lone_records();
  Status read_pictures();
  Status finish_bvh();
  void for_each(std::size_t count, const std::function<void(std::size_t)>& body) const;

  const SectionTable& table_;
  VerifyOptions options_;
  bool parallel_;
  VerifiedScene result_;
  std::optional<ArrayLimits> limits_;
  std::optional<BvhVerifier> bvh_;
  std::vector<std::size_t> cuts_;  // which nodes are checked with each chunk of leaves
  std::vector<std::vector<std::uint64_t>> hashes_;  // of each section's chunks
  FirstFault faults_;
};

// Points the view at the sections: all it takes are the counts in the table.
Status Verifier::lay_out() {
  const SectionEntry* camera = table_.find(SectionType::camera);
  if (camera == nullptr || camera->count != 1) {
    return damaged_at(sizeof(FileHeader), "there must be one camera");
  }
  SceneView& view = result_.view;
  view.runs = table_.elements<ObjectRun>(SectionType::runs);
  for_each_array(
      [&](SceneArray array, auto& elements) {
        using Element = typename std::remove_reference_t<decltype(elements)>::element_type;
        elements = table_.elements<std::remove_const_t<Element>>(section_of(array));
      },
      view);
  limits_.emplace(view, table_.elements<MaterialRecord>(SectionType::materials).size());
  view.bvh.nodes = table_.elements<WideNode>(SectionType::bvh_nodes);
  view.bvh.rows = table_.elements<LeafRow>(SectionType::bvh_leaves);
  // Counts of objects take the prototypes, so these come first.
  const std::size_t bad =
      first_invalid(view, *limits_, SceneArray::prototypes, 0, view.prototypes.size());
  if (bad < view.prototypes.size()) {
    report(*table_.find(SectionType::prototypes), SceneArray::prototypes, bad);
    return faults_.status();
  }
  if (prim_count(view) > kMaxObjectCount) {
    return damaged_at(sizeof(FileHeader), fmt::format("more than {} objects", kMaxObjectCount));
  }
  if (view.bvh.nodes.empty() != view.bvh.rows.empty()) {
    return damaged_at(sizeof(FileHeader), "of the BVH's two sections one is missing");
  }
  if (!view.bvh.empty()) {
    bvh_.emplace(view.bvh, view);
    cuts_ = bvh_->cuts_by_rows(kHashChunk / sizeof(LeafRow));
  }
  return {};
}

void Verifier::for_each(std::size_t count, const std::function<void(std::size_t)>& body) const {
  if (parallel_) return parallel_for_dynamic(count, body);
  for (std::size_t i = 0; i < count; ++i) body(i);
}

// Everything that can be done to pieces in any order. The walk over the whole tree, the longest
// piece, comes first.
void Verifier::check_contents() {
  std::vector<Chunk> chunks;
  hashes_.reserve(table_.entries().size());
  for (const SectionEntry& section : table_.entries()) {
    auto& hashes = hashes_.emplace_back(is_skipped(section) ? 0 : hash_chunk_count(section.size));
    for (std::size_t i = 0; i < hashes.size(); ++i) {
      chunks.push_back({&section, i * kHashChunk, &hashes[i]});
    }
  }
  for_each(chunks.size() + 1, [&](std::size_t i) {
    if (i > 0) return check_chunk(chunks[i - 1]);
    if (bvh_) report(bvh_->check_order());
  });
}

void Verifier::check_chunk(const Chunk& chunk) {
  const std::uint64_t size = std::min<std::uint64_t>(chunk.section->size - chunk.begin, kHashChunk);
  const auto bytes = table_.bytes(*chunk.section).subspan(chunk.begin, size);
  if (options_.hashes) *chunk.hash = hash_bytes(bytes);
  check_piece(*chunk.section, chunk.begin, size);
}

// Elements that begin in the piece, of arrays that are used as they stand.
void Verifier::check_piece(const SectionEntry& section, std::uint64_t begin, std::uint64_t size) {
  const SectionKind* kind = find_section_kind(section.type);
  if (kind != nullptr && kind->array) {
    const auto element_from = [&](std::uint64_t byte) {
      return static_cast<std::size_t>((byte + section.stride - 1) / section.stride);
    };
    const std::size_t end = element_from(begin + size);
    const std::size_t bad =
        first_invalid(result_.view, *limits_, *kind->array, element_from(begin), end);
    if (bad < end) report(section, *kind->array, bad);
  }
  if (SectionType{section.type} == SectionType::bvh_leaves) {
    const std::size_t part = begin / kHashChunk;
    report(bvh_->check_nodes(cuts_[part], cuts_[part + 1]));
  }
}

void Verifier::report(const SectionEntry& section, SceneArray array, std::size_t index) {
  faults_.report(section.offset + index * section.stride,
                 fmt::format("{} {}: {}", element_name(array), index,
                             why_invalid(result_.view, *limits_, array, index)));
}

void Verifier::report(const BvhDamage& damage) {
  if (damage.ok()) return;
  faults_.report(offset_of_node(damage.node),
                 fmt::format("BVH node {}: {}", damage.node, damage.reason));
}

Status Verifier::check_hashes() const {
  if (!options_.hashes) return {};
  for (std::size_t i = 0; i < hashes_.size(); ++i) {
    const SectionEntry& section = table_.entries()[i];
    if (is_skipped(section) || hash_of_chunks(hashes_[i]) == section.hash) continue;
    return damaged_at(section.offset, fmt::format("the checksum of section {} is wrong",
                                                  section_name(section.type)));
  }
  return {};
}

Status Verifier::decode_small_sections() {
  SceneView& view = result_.view;
  const auto camera = decode_camera(table_.elements<CameraRecord>(SectionType::camera).front());
  if (!camera) return damaged_at(offset_of(SectionType::camera), to_string(camera.error()));
  view.camera = *camera;
  if (auto status = read_lone_records(); !status) return status;
  if (auto status = read_pictures(); !status) return status;

  const auto records = table_.elements<MaterialRecord>(SectionType::materials);
  result_.materials.reserve(records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto material = decode_material(records[i]);
    if (!material) {
      return damaged_at(offset_of(SectionType::materials) + i * sizeof(MaterialRecord),
                        fmt::format("material {}: {}", i, material.error().message));
    }
    const auto* layered = std::get_if<Layered>(&*material);
    if (layered != nullptr && layered->index >= limits_->layered_materials) {
      return damaged_at(offset_of(SectionType::materials) + i * sizeof(MaterialRecord),
                        fmt::format("material {}: its layered material does not exist", i));
    }
    result_.materials.push_back(*material);
  }
  view.materials = result_.materials;

  for (const RunRecord& run : table_.elements<RunRecord>(SectionType::runs)) {
    if (run.reserved != 0) {
      return damaged_at(offset_of(SectionType::runs), "reserved fields are not zero");
    }
  }
  if (auto status = validate_counts(view); !status) {
    return damaged_at(offset_of(SectionType::runs), to_string(status.error()));
  }
  if (const auto index = instance_too_far(view)) {
    return damaged_at(offset_of(SectionType::instances) + *index * sizeof(Instance),
                      fmt::format("instance {}: it reaches beyond {:g}", *index, kMaxCoordinate));
  }
  return {};
}

// Sections of at most one element, each left out when it is what a scene is like without it.
Status Verifier::read_lone_records() {
  SceneView& view = result_.view;
  const auto heights = table_.elements<double>(SectionType::orthographic);
  const auto environments = table_.elements<Environment>(SectionType::environment);
  if (heights.size() > 1 || (heights.size() == 1 && !(heights[0] > 0))) {
    return damaged_at(offset_of(SectionType::orthographic), "there must be one positive height");
  }
  if (heights.size() == 1) view.camera.orthographic_height = heights[0];
  if (auto status = validate(view.camera); !status) {
    return damaged_at(offset_of(SectionType::orthographic), to_string(status.error()));
  }
  if (environments.empty()) return {};
  const std::string reason = reason_against(environments[0], limits_->images);
  if (environments.size() > 1 || !reason.empty()) {
    return damaged_at(offset_of(SectionType::environment),
                      "environment: " + (reason.empty() ? "there is more than one" : reason));
  }
  view.environment = environments[0];
  return {};
}

Status Verifier::read_pictures() {
  const auto films = table_.elements<FilmRecord>(SectionType::film);
  const auto aspects = table_.elements<double>(SectionType::camera_aspects);
  if (films.size() > 1) return damaged_at(offset_of(SectionType::film), "more than one film");
  PictureShape& pictures = result_.pictures;
  if (!films.empty()) pictures.resolution = decode_film(films[0]);
  std::string reason = reason_against(pictures, result_.view.cameras.size());
  if (!reason.empty()) return damaged_at(offset_of(SectionType::film), reason);
  pictures.camera_aspects.assign(aspects.begin(), aspects.end());
  reason = reason_against(pictures, result_.view.cameras.size());
  if (!reason.empty()) return damaged_at(offset_of(SectionType::camera_aspects), reason);
  return {};
}

// What takes that everything else holds.
Status Verifier::finish_bvh() {
  if (!bvh_) return {};
  report(bvh_->check_count());
  if (auto status = faults_.status(); !status || skip_shapes()) return status;
  for_each(cuts_.size() - 1,
           [&](std::size_t i) { report(bvh_->check_shapes(cuts_[i], cuts_[i + 1])); });
  if (auto status = faults_.status(); !status) return status;
  report(bvh_->check_complete());
  return faults_.status();
}

}  // namespace

Expected<VerifiedScene> verify(std::span<const std::byte> file, const VerifyOptions& options) {
  if (reinterpret_cast<std::uintptr_t>(file.data()) % kSectionAlignment != 0) {
    return fail(Errc::internal, "", "a scene file must lie at a multiple of 64 in memory");
  }
  const auto table = SectionTable::read(file, options.hashes);
  if (!table) return tl::unexpected(table.error());
  return Verifier(*table, file.size(), options).run();
}

}  // namespace dapple
