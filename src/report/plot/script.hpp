// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "glissade/report/figure.hpp"

// A gnuplot script can run commands. So it is put together of literals, numbers and types that
// cannot: text becomes part of it as Quoted, names of files as FileName.
namespace glissade::gnuplot {

/// A single-quoted string, in which gnuplot substitutes nothing. Text shows as it is, no character
/// acting as markup; `S_DS`, `S_1` ... are set as symbols, a quote as an apostrophe.
class Quoted {
 public:
  enum class Weight { plain, bold };
  explicit Quoted(std::string_view plain, Weight weight = Weight::plain);
  const std::string& str() const { return quoted_; }

 private:
  std::string quoted_;
};

/// A word or phrase of gnuplot that stands in the source.
struct Word {
  const char* text;
  consteval Word(const char* literal) : text(literal) {}
};

// What may be part of a script, and as what.
inline double piece(double number) { return number; }
inline int piece(int number) { return number; }
inline std::size_t piece(std::size_t number) { return number; }
inline const char* piece(Word word) { return word.text; }
inline std::string piece(Colour colour) { return fmt::format("'#{:06x}'", colour.rgb & 0xffffff); }
inline const std::string& piece(const Quoted& text) { return text.str(); }
inline const std::string& piece(const FileName& name) { return name.text(); }
void piece(const std::string&) = delete;
void piece(std::string_view) = delete;
void piece(const char*) = delete;

template <class Part>
concept Scriptable = requires(const Part& part) {
  piece(part);
};

class Script {
 public:
  /// Adds a literal format with its parts.
  template <Scriptable... Part>
  void add(fmt::format_string<decltype(piece(std::declval<const Part&>()))...> format,
           const Part&... part) {
    text_ += fmt::format(format, piece(part)...);
  }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

/// The name of a figure as gnuplot's terminal takes it, without -.
FileName identifier(const FileName& name);
/// The script of a figure: it writes NAME.svg and NAME.pdf from NAME.dat.
std::string script_of(const Figure& figure);
/// NAME.dat: a block for each series with numbers, in order.
std::string data_of(const Figure& figure);

/// Runs `gnuplot --default-settings script` in `folder`. Throws InputError if it is missing or
/// fails.
void run(const std::filesystem::path& folder, const std::string& script);

}  // namespace glissade::gnuplot
