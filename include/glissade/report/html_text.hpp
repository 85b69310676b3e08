// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace glissade {

/// Markup that stands in the source: nothing read from a file can become one.
struct Markup {
  const char* text;
  consteval Markup(const char* literal) : text(literal) {}
};

/// A piece of a page. Markup is literal; all other text is escaped on its way in.
class Html {
 public:
  Html() = default;
  explicit Html(Markup markup) : page_(markup.text) {}
  /// & < > " ' as entities: safe as text and inside quoted attributes.
  static Html text(std::string_view plain);
  /// A drawing of gnuplot, from its <svg on, with a label for readers that do not show it.
  static Html drawing(const std::string& svg, std::string_view label);

  Html& operator+=(const Html& next) {
    page_ += next.page_;
    return *this;
  }
  Html& operator+=(Markup next) {
    page_ += next.text;
    return *this;
  }
  friend Html operator+(Html first, const Html& next) { return std::move(first += next); }
  friend Html operator+(Html first, Markup next) { return std::move(first += next); }
  friend Html operator+(Markup first, const Html& next) { return Html(first) + next; }
  const std::string& str() const { return page_; }

 private:
  std::string page_;
};

/// `text` between `before` and `after`.
Html enclosed(Markup before, std::string_view text, Markup after);

}  // namespace glissade
