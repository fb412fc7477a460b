#include "report/layout.h"

#include <cstring>
#include <vector>

#include "report/csv_file.h"
#include "scene_file/format.h"
#include "scene_file/scene_source.h"
#include "scene_file/writer.h"

namespace dapple::bench {
namespace {

template <class Record>
Record read_at(const std::vector<std::byte>& bytes, std::size_t offset) {
  Record record;
  std::memcpy(&record, bytes.data() + offset, sizeof(record));
  return record;
}

std::string letters(std::uint32_t type) {
  std::string text(4, ' ');
  std::memcpy(text.data(), &type, 4);
  return text;
}

}  // namespace

Status study_layout(const std::string& folder) {
  const auto scene = SceneSource::open("nice");
  if (!scene) return tl::unexpected(scene.error());
  std::vector<std::byte> bytes;
  const auto collect = [&](std::span<const std::byte> piece) -> Status {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    return {};
  };
  if (auto status = write_scene_bytes(scene->view(), collect); !status) return status;
  CsvFile csv({"section", "offset", "size", "count", "stride"});
  const auto header = read_at<FileHeader>(bytes, 0);
  csv.add("header", 0, sizeof(FileHeader), 1, sizeof(FileHeader));
  csv.add("table", sizeof(FileHeader), header.section_count * sizeof(SectionEntry),
          header.section_count, sizeof(SectionEntry));
  for (std::size_t i = 0; i < header.section_count; ++i) {
    const auto entry = read_at<SectionEntry>(bytes, sizeof(FileHeader) + i * sizeof(SectionEntry));
    csv.add(letters(entry.type), entry.offset, entry.size, entry.count, entry.stride);
  }
  csv.add("end", bytes.size(), 0, 0, 0);
  return csv.write(folder + "/layout.csv");
}

}  // namespace dapple::bench
