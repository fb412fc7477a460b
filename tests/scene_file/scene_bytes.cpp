#include "tests/scene_file/scene_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/scene_arrays.h"
#include "scene_file/records.h"
#include "scene_file/section_hash.h"
#include "scene_file/writer.h"
#include "tests/scene_file/small_bvh.h"

namespace dapple::test {

std::vector<std::byte> scene_bytes(const SceneView& scene, const PictureShape& pictures) {
  std::vector<std::byte> file;
  const auto append = [&](std::span<const std::byte> bytes) -> Status {
    file.insert(file.end(), bytes.begin(), bytes.end());
    return {};
  };
  const auto status = write_scene_bytes(scene, append, pictures);
  EXPECT_TRUE(status) << to_string(status.error());
  return file;
}

std::vector<std::byte> scene_bytes_with_bvh(const Scene& scene, std::size_t max_children,
                                            std::size_t max_leaf) {
  const SmallBvh bvh = build_small_bvh(scene, max_children, max_leaf);
  SceneView view = scene;
  view.bvh = bvh.view();
  return scene_bytes(view);
}

FileParts::FileParts(std::span<const std::byte> file) {
  std::memcpy(&header, file.data(), sizeof(header));
  sections.resize(header.section_count);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    auto& [entry, bytes] = sections[i];
    std::memcpy(&entry, file.data() + sizeof(header) + i * sizeof(entry), sizeof(entry));
    const auto content = file.subspan(entry.offset, entry.size);
    bytes.assign(content.begin(), content.end());
  }
}

FileParts::Section& FileParts::section(SectionType type) {
  return *std::find_if(sections.begin(), sections.end(), [&](const Section& s) {
    return s.entry.type == static_cast<std::uint32_t>(type);
  });
}

bool FileParts::has(SectionType type) const {
  return std::any_of(sections.begin(), sections.end(), [&](const Section& s) {
    return s.entry.type == static_cast<std::uint32_t>(type);
  });
}

std::vector<std::byte> FileParts::bytes(
    const std::function<void(std::span<SectionEntry>)>& change) const {
  std::vector<std::byte> file(sizeof(FileHeader) + sections.size() * sizeof(SectionEntry));
  std::vector<SectionEntry> table;
  for (const auto& [entry, content] : sections) {
    table.push_back(entry);
    table.back().offset = align_up(file.size(), entry.alignment);
    std::vector<std::uint64_t> hashes;
    for (std::size_t at = 0; at < content.size(); at += kHashChunk) {
      const std::size_t size = std::min(kHashChunk, content.size() - at);
      hashes.push_back(hash_bytes(std::span(content).subspan(at, size)));
    }
    table.back().hash = hash_of_chunks(hashes);
    file.resize(table.back().offset);
    file.insert(file.end(), content.begin(), content.end());
  }
  if (change) change(table);
  FileHeader top = header;
  top.file_size = file.size();
  top.section_count = static_cast<std::uint32_t>(table.size());
  top.table_hash = hash_bytes(std::as_bytes(std::span(table)));
  const auto hashed = std::as_bytes(std::span(&top, 1)).first(offsetof(FileHeader, header_hash));
  top.header_hash = hash_bytes(hashed);
  std::memcpy(file.data(), &top, sizeof(top));
  if (!table.empty()) {
    std::memcpy(file.data() + sizeof(top), table.data(), table.size() * sizeof(SectionEntry));
  }
  return file;
}

namespace {

template <class T>
bool same_bits(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

template <class T>
bool same_records(std::span<const T> a, std::span<const T> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) {
    const auto record_x = encode(x);
    const auto record_y = encode(y);
    return std::memcmp(&record_x, &record_y, sizeof(record_x)) == 0;
  });
}

}  // namespace

bool same_scene(const SceneView& a, const SceneView& b) {
  bool same = same_bits(std::span(&a.camera, 1), std::span(&b.camera, 1)) &&
              same_records(a.materials, b.materials) && same_records(a.runs, b.runs) &&
              same_bits(std::span(&a.environment, 1), std::span(&b.environment, 1)) &&
              same_bits(a.bvh.nodes, b.bvh.nodes) && same_bits(a.bvh.rows, b.bvh.rows);
  for_each_array(
      [&](SceneArray, const auto& of_a, const auto& of_b) { same = same && same_bits(of_a, of_b); },
      a, b);
  return same;
}

}  // namespace dapple::test
