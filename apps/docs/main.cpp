// dapple_docs FOLDER: writes the man pages and shell completions below FOLDER.
#include <filesystem>

#include "common/program.h"
#include "dapple/version.h"
#include "docs/documents.h"
#include "util/atomic_file.h"

namespace dapple {
namespace {

Expected<int> write_documents(const std::filesystem::path& folder) {
  for (const Document& document : make_documents(DAPPLE_VERSION)) {
    const std::filesystem::path path = folder / document.path;
    std::filesystem::create_directories(path.parent_path());
    const auto bytes = std::as_bytes(std::span(document.text));
    if (auto status = write_file_atomically(path.string(), bytes); !status) {
      return tl::unexpected(status.error());
    }
  }
  return 0;
}

}  // namespace
}  // namespace dapple

int main(int argc, char** argv) {
  dapple::prepare_process(static_cast<int>(dapple::Errc::io));
  const auto result = dapple::call_guarded([&]() -> dapple::Expected<int> {
    if (argc != 2) return dapple::fail(dapple::Errc::usage, "usage", "dapple_docs FOLDER");
    return dapple::write_documents(argv[1]);
  });
  if (result) return *result;
  dapple::report("dapple_docs", result.error());
  return static_cast<int>(result.error().code);
}
