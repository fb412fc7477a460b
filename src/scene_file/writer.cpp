#include "scene_file/writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "parallel/parallel.h"
#include "scene/validate.h"
#include "scene_file/records.h"
#include "scene_file/section_hash.h"
#include "scene_file/section_table.h"
#include "scene_file/verify_bvh.h"
#include "util/atomic_file.h"
#include "util/hash.h"

namespace dapple {
namespace {

using Bytes = std::span<const std::byte>;
using Buffer = std::vector<std::byte>;

// What one section will hold: any part of it, on demand.
struct Section {
  SectionType type{};
  std::uint64_t count = 0;
  // Bytes [begin, begin + size) of the section, where they lie or made in `buffer`.
  std::function<Bytes(std::uint64_t begin, std::uint64_t size, Buffer& buffer)> part;
};

template <class T>
Section as_it_stands(SectionType type, std::span<T> elements) {
  return {type, elements.size(),
          [bytes = std::as_bytes(elements)](std::uint64_t begin, std::uint64_t size, Buffer&) {
            return bytes.subspan(begin, size);
          }};
}

// Elements that have another form in the file are encoded a part at a time.
template <class T>
Section encoded(SectionType type, std::span<const T> elements) {
  using Record = decltype(encode(elements.front()));
  const auto part = [elements](std::uint64_t begin, std::uint64_t size, Buffer& buffer) -> Bytes {
    const std::uint64_t first = begin / sizeof(Record);
    const std::uint64_t last = (begin + size + sizeof(Record) - 1) / sizeof(Record);
    buffer.resize((last - first) * sizeof(Record));
    for (std::uint64_t i = first; i < last; ++i) {
      const Record record = encode(elements[i]);
      std::memcpy(buffer.data() + (i - first) * sizeof(Record), &record, sizeof(Record));
    }
    return Bytes(buffer).subspan(begin - first * sizeof(Record), size);
  };
  return {type, elements.size(), part};
}

// In the order of section_kinds(); those without elements, and those that would say what goes
// without saying, are left out.
std::vector<Section> sections_of(const SceneView& scene, const PictureShape& pictures) {
  std::vector<Section> sections = {encoded(SectionType::camera, std::span(&scene.camera, 1))};
  if (scene.camera.orthographic_height > 0) {
    sections.push_back(
        as_it_stands(SectionType::orthographic, std::span(&scene.camera.orthographic_height, 1)));
  }
  sections.push_back(encoded(SectionType::materials, scene.materials));
  sections.push_back(encoded(SectionType::runs, scene.runs));
  for_each_array(
      [&](SceneArray array, const auto& elements) {
        sections.push_back(as_it_stands(section_of(array), elements));
      },
      scene);
  if (!(scene.environment == Environment())) {
    sections.push_back(as_it_stands(SectionType::environment, std::span(&scene.environment, 1)));
  }
  if (pictures.resolution) {
    sections.push_back(encoded(SectionType::film, std::span(&*pictures.resolution, 1)));
  }
  sections.push_back(as_it_stands(SectionType::camera_aspects, std::span(pictures.camera_aspects)));
  if (!scene.bvh.empty()) {
    sections.push_back(as_it_stands(SectionType::bvh_nodes, scene.bvh.nodes));
    sections.push_back(as_it_stands(SectionType::bvh_leaves, scene.bvh.rows));
  }
  std::erase_if(sections, [](const Section& section) { return section.count == 0; });
  return sections;
}

std::uint64_t hash_section(const Section& section, std::uint64_t size) {
  std::vector<std::uint64_t> hashes(hash_chunk_count(size));
  const auto hash_chunk = [&](std::size_t i) {
    const std::uint64_t begin = i * kHashChunk;
    Buffer buffer;
    hashes[i] =
        hash_bytes(section.part(begin, std::min<std::uint64_t>(kHashChunk, size - begin), buffer));
  };
  if (hashes.size() > 1) {
    parallel_for_dynamic(hashes.size(), hash_chunk);
  } else if (hashes.size() == 1) {
    hash_chunk(0);
  }
  return hash_of_chunks(hashes);
}

std::vector<SectionEntry> make_table(std::span<const Section> sections) {
  std::vector<SectionEntry> table;
  std::uint64_t end = sizeof(FileHeader) + sections.size() * sizeof(SectionEntry);
  for (const Section& section : sections) {
    SectionEntry& entry = table.emplace_back();
    entry.type = static_cast<std::uint32_t>(section.type);
    const SectionKind& kind = *find_section_kind(entry.type);
    entry.flags = kind.flags;
    entry.alignment = kSectionAlignment;
    entry.offset = align_up(end, entry.alignment);
    entry.count = section.count;
    entry.stride = kind.stride;
    entry.size = entry.count * entry.stride;
    entry.hash = hash_section(section, entry.size);
    end = entry.offset + entry.size;
  }
  return table;
}

FileHeader make_header(std::span<const SectionEntry> table) {
  FileHeader header{};
  std::copy(std::begin(kMagic), std::end(kMagic), header.magic);
  header.endian_mark = kEndianMark;
  header.major = kFormatMajor;
  header.minor = kFormatMinor;
  header.file_size = table.back().offset + table.back().size;
  header.section_count = static_cast<std::uint32_t>(table.size());
  header.table_hash = hash_bytes(std::as_bytes(table));
  header.header_hash =
      hash_bytes(std::as_bytes(std::span(&header, 1)).first(offsetof(FileHeader, header_hash)));
  return header;
}

Status write_section(const Section& section, std::uint64_t size, const ByteSink& write) {
  constexpr std::uint64_t kWriteSize = std::uint64_t{8} << 20;
  Buffer buffer;
  for (std::uint64_t begin = 0; begin < size; begin += kWriteSize) {
    const auto part = section.part(begin, std::min(kWriteSize, size - begin), buffer);
    if (auto status = write(part); !status) return status;
  }
  return {};
}

Status write_sections(std::span<const Section> sections, std::span<const SectionEntry> table,
                      const ByteSink& write) {
  constexpr std::array<std::byte, kSectionAlignment> kZeros{};
  std::uint64_t end = sizeof(FileHeader) + table.size_bytes();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const auto padding = Bytes(kZeros).first(table[i].offset - end);
    if (auto status = write(padding); !status) return status;
    if (auto status = write_section(sections[i], table[i].size, write); !status) return status;
    end = table[i].offset + table[i].size;
  }
  return {};
}

Status validate_bvh(const SceneView& scene) {
  if (scene.bvh.empty()) return {};
  if (scene.bvh.form != LeafForm::whole) {
    return fail(Errc::usage, "BVH", "the compact form cannot be stored");
  }
  const BvhDamage damage = BvhVerifier(scene.bvh, scene).check_everything();
  if (damage.ok()) return {};
  return fail(Errc::bad_data, "BVH", fmt::format("node {}: {}", damage.node, damage.reason));
}

Status validate_for_storing(const SceneView& scene, const PictureShape& pictures) {
  if (scene.bvh.nodes.empty() && scene.object_count() > 0 && !scene.bvh.rows.empty()) {
    return fail(Errc::bad_data, "BVH", "leaves without nodes");
  }
  if (auto status = validate(scene); !status) return status;
  const std::string reason = reason_against(pictures, scene.cameras.size());
  if (!reason.empty()) return fail(Errc::bad_data, "pictures", reason);
  return validate_bvh(scene);
}

Status write_validated(const SceneView& scene, const ByteSink& write,
                       const PictureShape& pictures) {
  const std::vector<Section> sections = sections_of(scene, pictures);
  const std::vector<SectionEntry> table = make_table(sections);
  const FileHeader header = make_header(table);
  if (auto status = write(std::as_bytes(std::span(&header, 1))); !status) return status;
  if (auto status = write(std::as_bytes(std::span(table))); !status) return status;
  return write_sections(sections, table, write);
}

}  // namespace

Status write_scene_bytes(const SceneView& scene, const ByteSink& write,
                         const PictureShape& pictures) {
  if (auto status = validate_for_storing(scene, pictures); !status) return status;
  return write_validated(scene, write, pictures);
}

Status store_scene_file(const std::string& path, const SceneView& scene,
                        const PictureShape& pictures) {
  if (auto status = validate_for_storing(scene, pictures); !status) return status;
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  const auto write = [&](Bytes bytes) { return file->write(bytes); };
  if (auto status = write_validated(scene, write, pictures); !status) return status;
  return file->commit();
}

}  // namespace dapple
