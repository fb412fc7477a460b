// The words of a pbrt file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "util/error.h"

namespace dapple::pbrt {

enum class TokenKind { word, text, open, close };

struct Token {
  TokenKind kind = TokenKind::word;
  std::string_view text;  // of `text`: without its quotation marks
  std::size_t line = 0;
};

// The text must outlive the tokens.
class Lexer {
 public:
  Lexer(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  // Nothing at the end of the file.
  [[nodiscard]] Expected<std::optional<Token>> next();
  // The same again at the next call.
  void put_back(const Token& token) { put_back_ = token; }

  [[nodiscard]] std::string place(const Token& token) const;
  [[nodiscard]] std::string place() const;

 private:
  void skip_blanks_and_comments();
  [[nodiscard]] Expected<std::optional<Token>> quoted();

  std::string_view text_;
  std::string name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  std::optional<Token> put_back_;
};

}  // namespace dapple::pbrt
