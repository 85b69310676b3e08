// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace glissade {

/// By its byte order mark.
bool is_utf16(std::string_view bytes);

/// In UTF-8, without the mark. What is no character becomes U+FFFD. Empty where more than a million
/// characters are not ASCII: no text of a record.
std::string from_utf16(std::string_view bytes);

/// In UTF-8: each byte is the character of its number (ISO 8859-1); control characters from 0x80 to
/// 0x9f become U+FFFD. Empty where more than a million characters are not ASCII.
std::string from_latin1(std::string_view bytes);

}  // namespace glissade
