#include "xml_values.hpp"

#include <charconv>
#include <cstdint>
#include <map>
#include <stdexcept>

namespace swarmanoid {
namespace {

std::string utf8Of(std::uint32_t code) {
  const auto byte = [code](unsigned mark, unsigned shift, unsigned mask) {
    return static_cast<char>(mark | ((code >> shift) & mask));
  };
  if (code < 0x80) {
    return {static_cast<char>(code)};
  }
  if (code < 0x800) {
    return {byte(0xC0, 6, 0x1F), byte(0x80, 0, 0x3F)};
  }
  if (code < 0x10000) {
    return {byte(0xE0, 12, 0x0F), byte(0x80, 6, 0x3F), byte(0x80, 0, 0x3F)};
  }
  return {byte(0xF0, 18, 0x07), byte(0x80, 12, 0x3F), byte(0x80, 6, 0x3F), byte(0x80, 0, 0x3F)};
}

/// The character of a reference such as "amp", "#97" or "#x61"; an empty string if there is none.
std::string characterOf(std::string_view reference) {
  static const std::map<std::string_view, char> kNamed{
      {"amp", '&'}, {"apos", '\''}, {"gt", '>'}, {"lt", '<'}, {"quot", '"'}};
  if (const auto found = kNamed.find(reference); found != kNamed.end()) {
    return {found->second};
  }
  constexpr std::uint32_t kLastCharacter = 0x10FFFF;
  const bool is_hexadecimal = reference.substr(0, 2) == "#x";
  const std::string_view digits = reference.substr(std::min<std::size_t>(is_hexadecimal ? 2 : 1, reference.size()));
  std::uint32_t code = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, is_hexadecimal ? 16 : 10);
  const bool is_number = reference.substr(0, 1) == "#" && error == std::errc() && end == digits.data() + digits.size();
  return is_number && code > 0 && code <= kLastCharacter ? utf8Of(code) : "";
}

}  // namespace

void refuseAt(int line, const std::string& problem) {
  throw std::runtime_error("line " + std::to_string(line) + ": found " + problem);
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kLongest = 100;
  return "'" + std::string(text.substr(0, kLongest)) + (text.size() > kLongest ? "..." : "") + "'";
}

std::string decoded(std::string_view raw, int line, bool is_attribute) {
  std::string result;
  result.reserve(raw.size());
  for (std::size_t at = 0; at < raw.size();) {
    std::size_t length = 1;
    if (raw[at] == '&') {
      const std::size_t end = std::min(raw.find(';', at), raw.size());
      const std::string character = characterOf(raw.substr(at + 1, end - at - 1));
      if (end == raw.size() || character.empty()) {
        refuseAt(line, "'&' in " + inQuotes(raw) + ", allowed: &amp;, &apos;, &gt;, &lt;, &quot; and &#number;");
      }
      length = end + 1 - at;
      result += character;
    } else if (raw[at] == '\r') {
      length = raw.compare(at, 2, "\r\n") == 0 ? 2 : 1;
      result += is_attribute ? ' ' : '\n';
    } else {
      const bool is_space = is_attribute && (raw[at] == '\t' || raw[at] == '\n');
      result += is_space ? ' ' : raw[at];
    }
    at += length;
  }
  return result;
}

std::string attributeOf(const XmlTag& tag, std::string_view name) {
  const auto found = tag.attributes.find(name);
  return found == tag.attributes.end() ? "" : decoded(found->second, tag.line, true);
}

std::string_view textOf(const XmlTag& tag) {
  if (!tag.has_only_text) {
    refuseAt(tag.line, "more than a text in <" + std::string(tag.name) + ">, allowed: values");
  }
  return tag.text;
}

std::size_t numberIn(std::string_view word, const std::string& what, int line, std::size_t most) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value > most) {
    refuseAt(line, what + " " + inQuotes(word) + ", allowed: a whole number from 0 to " + std::to_string(most));
  }
  return value;
}

std::size_t numberOf(const XmlTag& tag, const char* name, std::size_t fallback, std::size_t most) {
  const auto found = tag.attributes.find(name);
  const std::string what = std::string(name) + " of <" + std::string(tag.name) + ">";
  return found == tag.attributes.end() ? fallback : numberIn(found->second, what, tag.line, most);
}

}  // namespace swarmanoid
