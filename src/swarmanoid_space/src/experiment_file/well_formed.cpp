// What is not well-formed XML though the XML library lets it pass.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>

#include "xml_element.hpp"

namespace swarmanoid::experiment {
namespace {

/// Walks over the text. That every construct ends, and every element where it should, is left to the XML library.
class Walker {
 public:
  Walker(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  void walk() {
    if (text_.find('\0') != std::string::npos) {
      at_ = text_.find('\0');
      refuse("found a zero byte, allowed: text");
    }
    at_ = startsWith("\xEF\xBB\xBF") ? 3 : 0;
    while (at_ < text_.size()) {
      if (startsWith("<!--")) {
        skipBeyond("-->");
      } else if (startsWith("<![CDATA[")) {
        skipBeyond("]]>");
      } else if (startsWith("<?")) {
        skipBeyond("?>");
      } else if (startsWith("<!")) {
        refuse("found '<!', allowed: elements and comments <!-- ... -->");
      } else if (text_[at_] == '<') {
        readTag();
      } else {
        readCharacter();
      }
    }
  }

 private:
  static constexpr int kMostAttributes = 1000;  // the library compares each with all others

  bool startsWith(const char* prefix) const {
    return text_.compare(at_, std::char_traits<char>::length(prefix), prefix) == 0;
  }

  void skipBeyond(const char* end) {
    const std::size_t found = text_.find(end, at_);
    at_ = found == std::string::npos ? text_.size() : found + std::char_traits<char>::length(end);
  }

  void readCharacter() {
    const char c = text_[at_];
    if (depth_ == 0 && std::string(" \t\r\n").find(c) == std::string::npos) {
      refuse("found text outside <ahss-config>, allowed: nothing");
    }
    checkCharacter();
    ++at_;
  }

  void readTag() {
    const bool closes = startsWith("</");
    if (closes && depth_ == 0) {
      refuse("found a closing tag that does not match the open element");
    }
    const auto first = static_cast<unsigned char>(text_[std::min(at_ + (closes ? 2 : 1), text_.size() - 1)]);
    if (std::isalpha(first) == 0 && first != '_' && first < 0x80U) {
      refuse("found '<' without a name, allowed: a tag, or &lt; for the sign");
    }
    int attributes = 0;
    for (char quote = '\0'; at_ < text_.size() && (quote != '\0' || text_[at_] != '>'); ++at_) {
      const char c = text_[at_];
      attributes += quote == '\0' && c == '=' ? 1 : 0;
      if (attributes > kMostAttributes) {
        refuse("found a tag with more than " + std::to_string(kMostAttributes) + " attributes, allowed: fewer");
      }
      if (quote != '\0' && c == '<') {
        refuse("found '<' in an attribute, allowed: &lt;");
      }
      if (quote == '\0' && (c == '"' || c == '\'')) {
        quote = c;
      } else if (c == quote) {
        quote = '\0';
      }
      checkCharacter();
    }
    const bool is_empty = text_[at_ - 1] == '/';
    depth_ += closes ? -1 : is_empty ? 0 : 1;
    ++at_;
  }

  /// The library leaves what it does not know as it is, and takes numbers that stand for no character.
  void checkCharacter() const {
    const auto c = static_cast<unsigned char>(text_[at_]);
    if (c < 0x20U && c != '\t' && c != '\n' && c != '\r') {
      refuse("found the control character " + std::to_string(c) + ", allowed: text");
    }
    if (c != '&') {
      return;
    }
    constexpr std::size_t kLongest = 12;  // &#x0010FFFF; and some zeros
    const std::size_t end = text_.find(';', at_);
    const bool ends = end != std::string::npos && end - at_ <= kLongest;
    const std::string name = ends ? text_.substr(at_ + 1, end - at_ - 1) : "";
    const char* const kNames[] = {"amp", "lt", "gt", "quot", "apos"};
    if (std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames)) {
      return;
    }
    if (name.empty() || name[0] != '#') {
      refuse("found '&', allowed: &amp;, &lt;, &gt;, &quot;, &apos;");
    }
    if (!isCharacter(name)) {
      refuse("found '&" + name + ";', allowed: the number of a character of XML");
    }
  }

  /// @param name "#65" or "#x41"
  static bool isCharacter(const std::string& name) {
    const bool is_hexadecimal = name.size() > 1 && name[1] == 'x';
    const char* first = name.data() + (is_hexadecimal ? 2 : 1);
    const char* end = name.data() + name.size();
    std::uint32_t code = 0;
    const auto [stop, error] = std::from_chars(first, end, code, is_hexadecimal ? 16 : 10);
    const bool is_number = error == std::errc() && stop == end;
    const bool is_text = code >= 0x20U || code == '\t' || code == '\n' || code == '\r';
    const bool is_half = code >= 0xD800U && code <= 0xDFFFU;  // of a pair in UTF-16
    return is_number && is_text && !is_half && code <= 0x10FFFFU && code != 0xFFFEU && code != 0xFFFFU;
  }

  [[noreturn]] void refuse(const std::string& message) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(at_);
    throw ConfigError({file_, 1 + static_cast<int>(std::count(text_.begin(), end, '\n'))}, message);
  }

  const std::string& text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

void checkWellFormed(const std::string& text, const std::string& file) { Walker(text, file).walk(); }

}  // namespace swarmanoid::experiment
