#include "scene_file/section_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include "scene_file/foreign_file.h"
#include "util/hash.h"

namespace dapple {
namespace {

// Kinds of sections that are the bytes of an array.
constexpr SectionKind array_section(SectionType type, std::uint32_t stride, std::string_view name,
                                    SceneArray array) {
  return {type, stride, kSectionCritical, name, array};
}

constexpr std::array kSectionKinds = {
    SectionKind{SectionType::camera, sizeof(CameraRecord), kSectionCritical, "camera", {}},
    SectionKind{
        SectionType::orthographic, 8, kSectionCritical, "height of an orthographic picture", {}},
    SectionKind{SectionType::materials, sizeof(MaterialRecord), kSectionCritical, "materials", {}},
    SectionKind{SectionType::runs, sizeof(RunRecord), kSectionCritical, "object order", {}},
    array_section(SectionType::spheres, 32, "spheres", SceneArray::spheres),
    array_section(SectionType::sphere_materials, 4, "materials of spheres",
                  SceneArray::sphere_materials),
    array_section(SectionType::xy_rectangles, 40, "xy_rectangles", SceneArray::xy_rectangles),
    array_section(SectionType::xy_rectangle_materials, 4, "materials of xy_rectangles",
                  SceneArray::xy_rectangle_materials),
    array_section(SectionType::xz_rectangles, 40, "xz_rectangles", SceneArray::xz_rectangles),
    array_section(SectionType::xz_rectangle_materials, 4, "materials of xz_rectangles",
                  SceneArray::xz_rectangle_materials),
    array_section(SectionType::yz_rectangles, 40, "yz_rectangles", SceneArray::yz_rectangles),
    array_section(SectionType::yz_rectangle_materials, 4, "materials of yz_rectangles",
                  SceneArray::yz_rectangle_materials),
    array_section(SectionType::positions, 12, "vertex positions", SceneArray::positions),
    array_section(SectionType::normals, 12, "vertex normals", SceneArray::normals),
    array_section(SectionType::tangents, 16, "vertex tangents", SceneArray::tangents),
    array_section(SectionType::uvs0, 8, "first texture coordinates", SceneArray::uvs0),
    array_section(SectionType::uvs1, 8, "second texture coordinates", SceneArray::uvs1),
    array_section(SectionType::colours, 16, "vertex colours", SceneArray::colours),
    array_section(SectionType::triangles, 12, "triangles", SceneArray::triangles),
    array_section(SectionType::triangle_materials, 4, "materials of triangles",
                  SceneArray::triangle_materials),
    array_section(SectionType::cylinders, 56, "cylinders", SceneArray::cylinders),
    array_section(SectionType::cylinder_materials, 4, "materials of cylinders",
                  SceneArray::cylinder_materials),
    array_section(SectionType::prototypes, 8, "prototypes", SceneArray::prototypes),
    array_section(SectionType::instances, 52, "instances", SceneArray::instances),
    array_section(SectionType::layered_materials, 772, "layered materials",
                  SceneArray::layered_materials),
    array_section(SectionType::textures, 16, "textures", SceneArray::textures),
    array_section(SectionType::images, 24, "images", SceneArray::images),
    array_section(SectionType::texels, 1, "texels", SceneArray::texels),
    array_section(SectionType::lights, 48, "lights", SceneArray::lights),
    array_section(SectionType::cameras, 168, "cameras", SceneArray::cameras),
    SectionKind{SectionType::environment, 24, kSectionCritical, "environment", {}},
    SectionKind{SectionType::film, sizeof(FilmRecord), 0, "size of the film", {}},
    SectionKind{SectionType::camera_aspects, 8, 0, "shapes of the cameras' pictures", {}},
    SectionKind{SectionType::bvh_nodes, 448, 0, "BVH nodes", {}},
    SectionKind{SectionType::bvh_leaves, 64, 0, "BVH leaves", {}},
};

template <class T>
T read_struct(std::span<const std::byte> bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

Status check_version(const FileHeader& header) {
  if (header.major == kFormatMajor) return {};
  return fail(Errc::bad_data, "",
              fmt::format("format version {}.{} cannot be read by this program, which reads "
                          "version {}.x",
                          header.major, header.minor, kFormatMajor));
}

Status check_header(const FileHeader& header, std::span<const std::byte> file, bool hashes) {
  if (header.endian_mark != kEndianMark) return damaged_at(8, "wrong endian mark");
  if (auto status = check_version(header); !status) return status;
  if (hashes && hash_bytes(file.first(offsetof(FileHeader, header_hash))) != header.header_hash) {
    return damaged_at(0, "the header's checksum is wrong");
  }
  if (header.reserved != 0 || header.reserved2[0] != 0 || header.reserved2[1] != 0) {
    return damaged_at(28, "reserved header fields are not zero");
  }
  if (header.file_size != file.size()) {
    return damaged_at(16, fmt::format("the file is {} bytes long, its header says {}: it is "
                                      "truncated or was added to",
                                      file.size(), header.file_size));
  }
  if (header.section_count > kMaxSectionCount) {
    return damaged_at(
        24, fmt::format("{} sections are more than {}", header.section_count, kMaxSectionCount));
  }
  if (sizeof(FileHeader) + sizeof(SectionEntry) * header.section_count > file.size()) {
    return damaged_at(24, "the section table reaches beyond the end of the file");
  }
  return {};
}

const char* reason_against(const SectionEntry& entry) {
  if ((entry.flags & ~kSectionCritical) != 0) return "has unknown flags";
  if (entry.reserved[0] != 0 || entry.reserved[1] != 0) return "has reserved fields not zero";
  if (!std::has_single_bit(entry.alignment) || entry.alignment < kSectionAlignment ||
      entry.alignment > kMaxSectionAlignment) {
    return "has an alignment that is not allowed";
  }
  std::uint64_t product = 0;
  if (__builtin_mul_overflow(entry.count, std::uint64_t{entry.stride}, &product) ||
      product != entry.size) {
    return "has a size that is not count times stride";
  }
  const SectionKind* kind = find_section_kind(entry.type);
  if (kind == nullptr) {
    return (entry.flags & kSectionCritical) != 0
               ? "is not known to this version and cannot be skipped"
               : nullptr;
  }
  if (entry.stride != kind->stride) return "has the wrong stride";
  if (entry.flags != kind->flags) return "has the wrong flags";
  return nullptr;
}

bool is_zero(std::span<const std::byte> bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; });
}

// Each section must begin where the one before it, rounded up, ends: that alone makes them sorted,
// disjoint and without hidden space between.
const char* reason_against_place(const SectionEntry& entry, std::uint64_t end_before,
                                 std::span<const std::byte> file) {
  if (entry.offset != align_up(end_before, entry.alignment)) {
    return "does not begin right after the one before it";
  }
  if (entry.offset > file.size() || entry.size > file.size() - entry.offset) {
    return "reaches beyond the end of the file";
  }
  if (!is_zero(file.subspan(end_before, entry.offset - end_before))) {
    return "has padding before it that is not zero";
  }
  return nullptr;
}

Status check_entries(std::span<const SectionEntry> entries, std::span<const std::byte> file) {
  std::uint64_t end = sizeof(FileHeader) + entries.size_bytes();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const SectionEntry& entry = entries[i];
    const char* reason = reason_against(entry);
    if (reason == nullptr) reason = reason_against_place(entry, end, file);
    const auto same_type = [&](const SectionEntry& other) { return other.type == entry.type; };
    if (std::count_if(entries.begin(), entries.end(), same_type) != 1) reason = "is there twice";
    if (reason != nullptr) {
      return damaged_at(sizeof(FileHeader) + i * sizeof(SectionEntry),
                        fmt::format("section {} {}", section_name(entry.type), reason));
    }
    end = entry.offset + entry.size;
  }
  if (end != file.size()) return damaged_at(end, "there are bytes after the last section");
  return {};
}

}  // namespace

std::span<const SectionKind> section_kinds() { return kSectionKinds; }

const SectionKind* find_section_kind(std::uint32_t type) {
  const auto found = std::find_if(kSectionKinds.begin(), kSectionKinds.end(), [&](const auto& k) {
    return static_cast<std::uint32_t>(k.type) == type;
  });
  return found == kSectionKinds.end() ? nullptr : &*found;
}

SectionType section_of(SceneArray array) {
  return std::find_if(kSectionKinds.begin(), kSectionKinds.end(),
                      [&](const SectionKind& kind) { return kind.array == array; })
      ->type;
}

std::string section_name(std::uint32_t type) {
  std::string letters(4, ' ');
  std::memcpy(letters.data(), &type, 4);
  const bool printable = std::all_of(letters.begin(), letters.end(),
                                     [](unsigned char c) { return c > 32 && c < 127; });
  return printable ? letters : fmt::format("{:#010x}", type);
}

tl::unexpected<Error> damaged_at(std::uint64_t offset, const std::string& reason) {
  return fail(Errc::bad_data, "", fmt::format("at byte {}: {}", offset, reason));
}

Expected<SectionTable> SectionTable::read(std::span<const std::byte> file, bool check_hashes) {
  const std::size_t known = std::min(file.size(), sizeof(kMagic));
  if (known == 0) return fail(Errc::bad_data, "", "the file is empty");
  if (std::memcmp(file.data(), kMagic, known) != 0) {
    return fail(Errc::bad_data, "", "not a scene file: " + describe_foreign_file(file));
  }
  if (file.size() < sizeof(FileHeader)) {
    return damaged_at(file.size(), "the file ends inside its header");
  }
  const auto header = read_struct<FileHeader>(file, 0);
  if (auto status = check_header(header, file, check_hashes); !status) {
    return tl::unexpected(status.error());
  }
  SectionTable table(file);
  const auto rows = file.subspan(sizeof(FileHeader), sizeof(SectionEntry) * header.section_count);
  if (check_hashes && hash_bytes(rows) != header.table_hash) {
    return damaged_at(sizeof(FileHeader), "the section table's checksum is wrong");
  }
  table.entries_.resize(header.section_count);
  if (!rows.empty()) std::memcpy(table.entries_.data(), rows.data(), rows.size());
  if (auto status = check_entries(table.entries_, file); !status) {
    return tl::unexpected(status.error());
  }
  return table;
}

const SectionEntry* SectionTable::find(SectionType type) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const SectionEntry& e) {
    return e.type == static_cast<std::uint32_t>(type);
  });
  return found == entries_.end() ? nullptr : &*found;
}

}  // namespace dapple
