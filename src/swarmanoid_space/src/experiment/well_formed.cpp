// What is not well-formed XML though the XML library lets it pass.
#include <algorithm>
#include <regex>

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
    checkReference();
    ++at_;
  }

  void readTag() {
    const bool closes = startsWith("</");
    if (closes && depth_ == 0) {
      refuse("found a closing tag that does not match the open element");
    }
    for (char quote = '\0'; at_ < text_.size() && (quote != '\0' || text_[at_] != '>'); ++at_) {
      const char c = text_[at_];
      if (quote != '\0' && c == '<') {
        refuse("found '<' in an attribute, allowed: &lt;");
      }
      if (quote == '\0' && (c == '"' || c == '\'')) {
        quote = c;
      } else if (c == quote) {
        quote = '\0';
      }
      checkReference();
    }
    const bool is_empty = text_[at_ - 1] == '/';
    depth_ += closes ? -1 : is_empty ? 0 : 1;
    ++at_;
  }

  /// The library leaves what it does not know as it is.
  void checkReference() const {
    static const std::regex kReference("&(amp|lt|gt|quot|apos|#[0-9]+|#x[0-9a-fA-F]+);");
    const auto begin = text_.begin() + static_cast<std::ptrdiff_t>(at_);
    if (text_[at_] == '&' &&
        !std::regex_search(begin, text_.end(), kReference, std::regex_constants::match_continuous)) {
      refuse("found '&', allowed: &amp;, &lt;, &gt;, &quot;, &apos;");
    }
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
