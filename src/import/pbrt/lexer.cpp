#include "import/pbrt/lexer.h"

#include "import/text.h"

namespace dapple::pbrt {
namespace {

bool ends_word(char c) {
  return is_blank(c) || c == '\n' || c == '"' || c == '[' || c == ']' || c == '#';
}

}  // namespace

std::string Lexer::place(const Token& token) const { return line_place(name_, token.line); }
std::string Lexer::place() const { return line_place(name_, line_); }

void Lexer::skip_blanks_and_comments() {
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (c == '#') {
      position_ = std::min(text_.find('\n', position_), text_.size());
      continue;
    }
    if (!is_blank(c) && c != '\n') return;
    if (c == '\n') ++line_;
    ++position_;
  }
}

Expected<std::optional<Token>> Lexer::next() {
  if (put_back_) return std::exchange(put_back_, std::nullopt);
  skip_blanks_and_comments();
  if (position_ >= text_.size()) return std::nullopt;
  const char c = text_[position_];
  if (c == '"') return quoted();
  const std::size_t start = position_++;
  if (c == '[') return Token{TokenKind::open, text_.substr(start, 1), line_};
  if (c == ']') return Token{TokenKind::close, text_.substr(start, 1), line_};
  while (position_ < text_.size() && !ends_word(text_[position_])) ++position_;
  return Token{TokenKind::word, text_.substr(start, position_ - start), line_};
}

Expected<std::optional<Token>> Lexer::quoted() {
  const std::size_t start = ++position_;
  const std::size_t end = text_.find_first_of("\"\n", start);
  if (end == std::string_view::npos || text_[end] == '\n') {
    return fail(Errc::bad_data, place(), "a quotation mark is not closed");
  }
  position_ = end + 1;
  return Token{TokenKind::text, text_.substr(start, end - start), line_};
}

}  // namespace dapple::pbrt
