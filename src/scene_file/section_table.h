// The header and the section table of a scene file: what must be proven before anything else.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_arrays.h"
#include "scene_file/format.h"
#include "util/error.h"

namespace dapple {

// What this version knows of a type of section.
struct SectionKind {
  SectionType type;
  std::uint32_t stride;
  std::uint32_t flags;
  std::string_view name;
  std::optional<SceneArray> array;  // of which the section is the bytes
};

// In the order in which the writer stores them.
[[nodiscard]] std::span<const SectionKind> section_kinds();
[[nodiscard]] SectionType section_of(SceneArray array);
// Null when this version knows no such section.
[[nodiscard]] const SectionKind* find_section_kind(std::uint32_t type);

// "SPHR", or the number where a type is not four printable letters.
[[nodiscard]] std::string section_name(std::uint32_t type);

// The error of a damaged file: "at byte OFFSET: REASON"; its place is left to whoever knows the
// file's name.
[[nodiscard]] tl::unexpected<Error> damaged_at(std::uint64_t offset, const std::string& reason);

// The sections of a file, each inside it, none overlapping, with count times stride equal to size.
// What the sections hold is not looked at.
class SectionTable {
 public:
  [[nodiscard]] static Expected<SectionTable> read(std::span<const std::byte> file,
                                                   bool check_hashes);

  std::span<const SectionEntry> entries() const { return entries_; }
  // Null when the file has no such section.
  const SectionEntry* find(SectionType type) const;
  std::span<const std::byte> bytes(const SectionEntry& entry) const {
    return file_.subspan(entry.offset, entry.size);
  }
  // The elements where they lie; T must be the section's stride in size.
  template <class T>
  std::span<const T> elements(SectionType type) const {
    const SectionEntry* entry = find(type);
    if (entry == nullptr) return {};
    return {reinterpret_cast<const T*>(file_.data() + entry->offset), entry->count};
  }

 private:
  explicit SectionTable(std::span<const std::byte> file) : file_(file) {}

  std::span<const std::byte> file_;
  std::vector<SectionEntry> entries_;
};

}  // namespace dapple
