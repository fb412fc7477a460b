// Are files what their endings say?
#pragma once

#include <string>
#include <vector>

namespace dapple::scaling {

// What keeps the text from being well-formed XML, as far as we write it: no DTD, no comments, no
// CDATA. Empty when nothing does.
inline std::string xml_problem(const std::string& text) {
  std::vector<std::string> open;
  bool had_root = false;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '&') {
      bool known = false;
      for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;"}) {
        known = known || text.compare(at, std::string(entity).size(), entity) == 0;
      }
      if (!known) return "a lone &";
    }
    if (text[at] == '>') return "a lone >";
    if (text[at] != '<') {
      ++at;
      continue;
    }
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return "a tag without an end";
    std::string tag = text.substr(at + 1, end - at - 1);
    at = end + 1;
    if (tag.starts_with('?')) continue;
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1)) return "</" + tag.substr(1) + ">";
      open.pop_back();
      continue;
    }
    if (open.empty() && had_root) return "two roots";
    had_root = true;
    const bool closed = tag.ends_with('/');
    if (closed) tag.pop_back();
    for (std::size_t i = tag.find('='); i != std::string::npos;) {
      if (i + 1 >= tag.size() || tag[i + 1] != '"') return "an attribute without quotes: " + tag;
      const std::size_t quote = tag.find('"', i + 2);
      if (quote == std::string::npos) return "an open quote: " + tag;
      i = tag.find('=', quote);
    }
    if (!closed) open.push_back(tag.substr(0, tag.find_first_of(" \n")));
  }
  if (!had_root) return "no root";
  return open.empty() ? "" : "<" + open.back() + "> is left open";
}

// Lines and fields of comma-separated values; quoted fields may hold commas and "" for a quote.
inline std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  std::vector<std::string> line(1);
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      line.back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      line.emplace_back();
    } else if (!quoted && c == '\n') {
      lines.push_back(line);
      line.assign(1, "");
    } else {
      line.back() += c;
    }
  }
  return lines;
}

}  // namespace dapple::scaling
