/// Values in the tags of an XML text: strings as a parser decodes them, and whole numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "xml_tags.hpp"

namespace swarmanoid {

/// @throws std::runtime_error "line N: found PROBLEM"
[[noreturn]] void refuseAt(int line, const std::string& problem);

/// The text in quotation marks for a message, cut if it is long.
std::string inQuotes(std::string_view text);

/// Decodes a string as pugixml, the parser of assimp, does: references such as &amp; and &#97; become characters.
/// @param is_attribute tabs and ends of lines become spaces; in texts all ends of lines become "\n"
/// @throws std::runtime_error for any other '&'
std::string decoded(std::string_view raw, int line, bool is_attribute);

/// The decoded value, or an empty string if the tag has no such attribute.
std::string attributeOf(const XmlTag& tag, std::string_view name);

/// The raw text of an element. @throws std::runtime_error if the element has other content
std::string_view textOf(const XmlTag& tag);

/// @throws std::runtime_error unless the word is a whole number from 0 to `most`
std::size_t numberIn(std::string_view word, const std::string& what, int line, std::size_t most);

/// A numeric attribute. @param fallback value if the attribute is missing
std::size_t numberOf(const XmlTag& tag, const char* name, std::size_t fallback, std::size_t most);

/// Calls `take` for each word of a text.
template <class Take>
void forWords(std::string_view text, Take take) {
  std::size_t begin = 0;
  while ((begin = text.find_first_not_of(" \t\r\n", begin)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
    take(text.substr(begin, end - begin));
    begin = end;
  }
}

}  // namespace swarmanoid
