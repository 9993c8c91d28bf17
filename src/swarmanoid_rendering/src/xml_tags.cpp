#include "xml_tags.hpp"

#include <algorithm>
#include <stdexcept>

namespace swarmanoid {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

bool startsWith(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

}  // namespace

void XmlTags::refuse(const std::string& problem) {
  const auto begin = text_.begin() + static_cast<std::ptrdiff_t>(counted_);
  const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size()));
  throw std::runtime_error("line " + std::to_string(line_ + std::count(begin, end, '\n')) + ": found " + problem);
}

void XmlTags::skipPast(std::string_view end, const char* what) {
  const std::size_t place = text_.find(end, at_);
  if (place == std::string_view::npos) {
    refuse(std::string(what) + " without an end, allowed: '" + std::string(end) + "' after it");
  }
  at_ = place + end.size();
}

/// Rejects instructions inside elements: parsers read an instruction as a node with a name, and take the quotes of the
/// first one for those of an element.
void XmlTags::skipInstruction() {
  if (!open_.empty()) {
    refuse("an instruction in <" + std::string(open_.back()) + ">, allowed: before the first element");
  }
  const std::size_t begin = at_ + 2;
  at_ = begin;
  skipPast("?>", "an instruction");
  char quote = '\0';
  for (const char character : text_.substr(begin, at_ - begin)) {
    if (character == quote) {
      quote = '\0';
    } else if (quote == '\0' && (character == '"' || character == '\'')) {
      quote = character;
    }
  }
  if (quote != '\0') {
    refuse("an instruction with a quote that is not closed, allowed: name=\"value\"");
  }
}

bool XmlTags::findTag() {
  for (;;) {
    at_ = text_.find('<', at_);
    if (at_ == std::string_view::npos) {
      at_ = text_.size();
      return false;
    }
    const std::string_view rest = text_.substr(at_);
    if (startsWith(rest, "<!--")) {
      at_ += 4;  // "<!-->" does not end a comment
      skipPast("-->", "a comment");
    } else if (startsWith(rest, "<?")) {
      skipInstruction();
    } else if (startsWith(rest, "<!")) {
      refuse("'<!', allowed: elements and comments");
    } else {
      return true;
    }
  }
}

bool XmlTags::next(XmlTag& tag) {
  tag.attributes.clear();
  if (is_empty_element_) {
    is_empty_element_ = false;
    tag.kind = XmlTag::Kind::kClosing;
    tag.name = open_.back();
  } else {
    if (!findTag()) {
      if (!open_.empty()) {
        refuse("no end of <" + std::string(open_.back()) + ">, allowed: elements that are closed");
      }
      return false;
    }
    readName(tag);
  }
  if (tag.kind == XmlTag::Kind::kClosing) {
    close(tag);
  } else {
    readAttributes(tag);
  }
  const bool has_content = tag.kind == XmlTag::Kind::kOpening && !is_empty_element_;
  tag.text = text_.substr(at_, has_content ? std::min(text_.find('<', at_), text_.size()) - at_ : 0);
  tag.has_only_text = is_empty_element_ || startsWith(text_.substr(at_ + tag.text.size()), "</");
  return true;
}

void XmlTags::readName(XmlTag& tag) {
  const auto begin = text_.begin() + static_cast<std::ptrdiff_t>(counted_);
  line_ += static_cast<int>(std::count(begin, text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
  counted_ = at_;
  tag.line = line_;
  ++at_;
  tag.kind = XmlTag::Kind::kOpening;
  if (at_ < text_.size() && text_[at_] == '/') {
    tag.kind = XmlTag::Kind::kClosing;
    ++at_;
  }
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n/><=\"'", at_), text_.size());
  tag.name = text_.substr(at_, end - at_);
  at_ = end;
  if (tag.name.empty()) {
    refuse("'<' without a name, allowed: &lt;");
  }
}

void XmlTags::close(const XmlTag& tag) {
  if (open_.empty() || open_.back() != tag.name) {
    refuse("</" + std::string(tag.name) + ">, allowed: the end of the element that is open");
  }
  open_.pop_back();
  if (text_[at_ - 1] != '>') {  // otherwise the tag of an element without content
    skipSpace();
    if (at_ >= text_.size() || text_[at_] != '>') {
      refuse("</" + std::string(tag.name) + " without '>', allowed: nothing else in it");
    }
    ++at_;
  }
}

void XmlTags::skipSpace() { at_ = std::min(text_.find_first_not_of(kSpace, at_), text_.size()); }

void XmlTags::readAttributes(XmlTag& tag) {
  if (open_.size() >= kMostNested) {
    refuse("elements nested more than " + std::to_string(kMostNested) + " deep, allowed: fewer");
  }
  if (open_.empty() && has_root_) {
    refuse("<" + std::string(tag.name) + "> after the end of the first element, allowed: nothing");
  }
  has_root_ = true;
  open_.push_back(tag.name);
  for (;;) {
    skipSpace();
    const std::string_view rest = text_.substr(at_);
    if (startsWith(rest, ">")) {
      ++at_;
      return;
    }
    if (startsWith(rest, "/>")) {
      at_ += 2;
      is_empty_element_ = true;
      return;
    }
    const std::size_t end = std::min(rest.find_first_of(" \t\r\n/><=\"'"), rest.size());
    at_ += end;
    skipSpace();
    if (end == 0 || at_ >= text_.size() || text_[at_] != '=') {
      refuse("what is no attribute in <" + std::string(tag.name) + ">, allowed: name=\"value\"");
    }
    ++at_;
    skipSpace();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    const std::size_t close = quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : std::string_view::npos;
    if (close == std::string_view::npos) {
      refuse("a value without quotes around it in <" + std::string(tag.name) + ">, allowed: name=\"value\"");
    }
    if (!tag.attributes.emplace(rest.substr(0, end), text_.substr(at_ + 1, close - at_ - 1)).second) {
      refuse("an attribute twice in <" + std::string(tag.name) + ">, allowed: once");
    }
    at_ = close + 1;
  }
}

}  // namespace swarmanoid
