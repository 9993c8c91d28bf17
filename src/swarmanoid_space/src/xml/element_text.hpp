/// Writes parts of an XML document as text: elements in lines, indented by two spaces a level. (libxml2's writer, which
/// the schema is written with, writes whole documents, and keeps no line breaks in values.)
#pragma once

#include <string>
#include <vector>

namespace swarmanoid {

/// With what XML would take for its own replaced, so that it is read as it was.
std::string xmlEscaped(const std::string& text);

class ElementText {
 public:
  /// @param depth of the first element: how far it is indented
  explicit ElementText(int depth) : depth_(depth) {}

  /// What follows is in this element, until its `end`.
  void begin(const std::string& name);
  /// Of the element that has just begun.
  void attribute(const std::string& name, const std::string& value);
  void end();
  /// Ends an element that holds a value and no elements.
  void end(const std::string& value);
  /// A whole element that holds a value.
  void value(const std::string& name, const std::string& text);

  const std::string& text() const { return text_; }

 private:
  void indent();

  int depth_;
  std::string text_;
  std::vector<std::string> open_;
  bool is_tag_open_ = false;  // its attributes may follow
};

}  // namespace swarmanoid
