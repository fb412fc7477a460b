// bench_tables: puts the figures of benchmark runs into a Markdown document, or prints them.
#include <fmt/format.h>

#include <fstream>
#include <span>
#include <sstream>

#include "harness/command_line.h"
#include "tables/sections.h"
#include "tables/splice.h"
#include "util/atomic_file.h"

namespace dapple::bench {
namespace {

struct Options {
  std::vector<std::string> results;
  std::string document;
};

std::optional<int> read(int argc, char** argv, Options& o) {
  CommandLine line("Turns the JSON of benchmark runs into Markdown tables.");
  line.add_positional("results", "files written with --json", o.results);
  line.add("--document",
           "Markdown file whose marked sections are replaced; without it, tables "
           "go to standard output",
           o.document);
  return line.parse(argc, argv);
}

Expected<std::string> read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) return fail(Errc::no_input, path, "cannot be read");
  return text.str();
}

Status add_file(const std::string& path, Sections& sections) {
  const auto text = read_text(path);
  if (!text) return tl::unexpected(text.error());
  try {
    add_sections(nlohmann::json::parse(*text), sections);
  } catch (const nlohmann::json::exception& error) {
    return fail(Errc::bad_data, path, error.what());
  }
  return {};
}

void print(const Sections& sections) {
  for (const auto& [name, text] : sections) fmt::print("## {}\n\n{}\n", name, text);
}

Status update(const std::string& path, const Sections& sections) {
  auto document = read_text(path);
  if (!document) return tl::unexpected(document.error());
  for (const auto& [name, text] : sections) {
    if (auto status = splice(name, text, *document); !status) return status;
  }
  return write_file_atomically(path, std::as_bytes(std::span(*document)));
}

Status run(const Options& options) {
  Sections sections;
  for (const std::string& path : options.results) {
    if (auto status = add_file(path, sections); !status) return status;
  }
  if (!options.document.empty()) return update(options.document, sections);
  print(sections);
  return {};
}

}  // namespace
}  // namespace dapple::bench

int main(int argc, char** argv) {
  dapple::bench::Options options;
  if (const auto code = dapple::bench::read(argc, argv, options)) return *code;
  const dapple::Status status = dapple::bench::run(options);
  if (status) return 0;
  fmt::print(stderr, "bench_tables: {}\n", to_string(status.error()));
  return static_cast<int>(status.error().code);
}
