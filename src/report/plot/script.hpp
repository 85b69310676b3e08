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
/// Where a script draws to: NAME.svg and NAME.pdf in its folder, or files that are open.
struct Drawings {
  int svg = -1, pdf = -1;  ///< file descriptors
};
/// The script of a figure, which draws NAME.dat.
std::string script_of(const Figure& figure, const Drawings& to = {});
/// NAME.dat: a block for each series with numbers, in order.
std::string data_of(const Figure& figure);

/// What gnuplot draws of NAME.dat in `folder`, where it writes nothing. Throws InputError if it is
/// missing or fails.
struct Drawn {
  std::string svg, pdf;
};
Drawn draw(const Figure& figure, const std::filesystem::path& folder);

}  // namespace glissade::gnuplot
