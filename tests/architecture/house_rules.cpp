#include "tests/architecture/house_rules.h"

#include <filesystem>
#include <regex>
#include <set>

namespace dapple::architecture {
namespace {

bool is_source(const std::string& file) {
  return file.ends_with(".h") || file.ends_with(".hpp") || file.ends_with(".cpp") ||
         file.ends_with(".c");
}

bool is_header(const std::string& file) { return file.ends_with(".h") || file.ends_with(".hpp"); }

bool is_guarded(const std::string& file, const std::string& text) {
  static const std::regex macro(R"(#ifndef [A-Z_]+_H\n#define [A-Z_]+_H\n)");  // C has no other
  return text.find("#pragma once") != std::string::npos || file.ends_with("-inl.h") ||
         std::regex_search(text, macro);
}

struct Rule {
  std::regex pattern;
  std::vector<std::string> except;  // beginnings of the paths where it is allowed
  std::string reason;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = {
      {std::regex(R"(std::(cout|cerr|clog)\b|\b(fmt::print|printf|puts|putchar|perror)\s*\()"),
       {},
       "a library does not print"},
      // A signal handler may end the process after a mapped file was cut short under its reader.
      {std::regex(R"(\b(std::|::)?(exit|_exit|_Exit|quick_exit|abort|terminate)\s*\()"),
       {"src/util/mapped_ranges.cpp"},
       "a library does not end the process"},
      {std::regex(R"(#\s*pragma\s+omp\b|<omp\.h>)"), {"src/parallel/"}, "OpenMP is in parallel/"},
      {std::regex(R"(<hwy/)"),
       {"src/accel/kernels/", "src/render/kernels/", "src/math/simd-inl.h",
        "src/scene_file/leaf_check"},
       "Highway is in kernels/ and math/simd-inl.h"},
      {std::regex(R"(\bstd::(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|)"
                  R"(log2|log10|log1p|pow|cbrt|hypot|erf|tgamma)f?\s*\()"),
       {},
       "its result depends on the C library and processor; see math/functions.h"},
      {std::regex(R"(<random>)"), {}, "random numbers come from math/random.h"},
  };
  return all;
}

bool is_excepted(const Rule& rule, const std::string& file) {
  for (const std::string& beginning : rule.except) {
    if (file.starts_with(beginning)) return true;
  }
  return false;
}

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    found.insert((*it)[1]);
  }
  return found;
}

bool leads_somewhere(const SourceTree& tree, const std::string& page, const std::string& link) {
  const auto folder = std::filesystem::path(page).parent_path();
  std::string target = (folder / link).lexically_normal().generic_string();
  if (target.ends_with('/')) target.pop_back();
  if (tree.contains(target)) return true;
  const auto next = tree.lower_bound(target + "/");
  return next != tree.end() && next->first.starts_with(target + "/");
}

}  // namespace

std::vector<std::string> naming_violations(const SourceTree& tree) {
  static const std::regex name(R"([a-z][a-z0-9_]*(-inl)?\.(h|hpp|cpp|c))");
  std::vector<std::string> violations;
  for (const auto& [file, text] : tree) {
    if (!is_source(file)) continue;
    if (!std::regex_match(path_parts(file).back(), name)) {
      violations.push_back(file + ": is not named in snake_case");
    }
    if (is_header(file) && !is_guarded(file, text)) violations.push_back(file + ": has no guard");
  }
  return violations;
}

std::vector<std::string> length_violations(const SourceTree& tree) {
  std::vector<std::string> long_files;
  std::size_t files = 0;
  for (const auto& [file, text] : tree) {
    if (!is_source(file)) continue;
    ++files;
    const std::size_t lines = lines_of(text).size();
    if (lines >= 300) long_files.push_back(file + ": has " + std::to_string(lines) + " lines");
  }
  return long_files.size() * 10 > files ? long_files : std::vector<std::string>{};
}

std::vector<std::string> forbidden_calls(const SourceTree& tree) {
  std::vector<std::string> violations;
  for (const auto& [file, text] : tree) {
    if (!file.starts_with("src/") || !is_source(file)) continue;
    const auto lines = lines_of(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const Rule& rule : rules()) {
        if (is_excepted(rule, file) ||
            !std::regex_search(without_comment(lines[i]), rule.pattern)) {
          continue;
        }
        violations.push_back(file + ":" + std::to_string(i + 1) + ": " + rule.reason);
      }
    }
  }
  return violations;
}

std::vector<std::string> citation_violations(const SourceTree& tree) {
  static const std::regex key(R"(\[([A-Z][A-Za-z]+[0-9]{2})\])");
  static const std::regex entry(R"(@[a-z]+\{([A-Za-z0-9]+),)");
  const auto bibliography = tree.find("docs/references.bib");
  if (bibliography == tree.end()) return {"docs/references.bib: is missing"};
  const std::set<std::string> entries = matches(bibliography->second, entry);
  std::set<std::string> cited;
  std::vector<std::string> violations;
  for (const auto& [file, text] : tree) {
    if (!is_source(file) && !file.ends_with(".md")) continue;
    for (const std::string& line : lines_of(text)) {
      for (const std::string& found : matches(is_source(file) ? comment_of(line) : line, key)) {
        cited.insert(found);
        if (!entries.contains(found)) violations.push_back(file + ": no entry for " + found);
      }
    }
  }
  for (const std::string& known : entries) {
    if (!cited.contains(known)) violations.push_back("docs/references.bib: nobody cites " + known);
  }
  return violations;
}

std::vector<std::string> broken_links(const SourceTree& tree) {
  static const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))");
  std::vector<std::string> violations;
  for (const auto& [file, text] : tree) {
    if (!file.ends_with(".md")) continue;
    for (const std::string& target : matches(text, link)) {
      if (target.find("://") != std::string::npos || target.starts_with("mailto:")) continue;
      if (!leads_somewhere(tree, file, target)) violations.push_back(file + ": " + target);
    }
  }
  return violations;
}

}  // namespace dapple::architecture
