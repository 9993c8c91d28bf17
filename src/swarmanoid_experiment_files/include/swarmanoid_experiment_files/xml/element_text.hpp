/// Writes parts of an XML document as text: one element per line, indented by two spaces per level. (libxml2's writer,
/// which writes the schema, writes whole documents only, and does not keep line breaks in values.)
#pragma once

#include <string>
#include <vector>

namespace swarmanoid {

/// Returns the text with XML's special characters replaced, so that it is read back unchanged.
std::string xmlEscaped(const std::string& text);

class ElementText {
 public:
  /// @param depth indentation level of the first element
  explicit ElementText(int depth) : depth_(depth) {}

  /// Opens an element; later calls write into it, until its `end`.
  void begin(const std::string& name);
  /// Writes an attribute of the element that was just opened.
  void attribute(const std::string& name, const std::string& value);
  void end();
  /// Ends an element that holds a value and no elements.
  void end(const std::string& value);
  /// Writes a whole element that holds a value.
  void value(const std::string& name, const std::string& text);

  const std::string& text() const { return text_; }

 private:
  void indent();

  int depth_;
  std::string text_;
  std::vector<std::string> open_;
  bool is_tag_open_ = false;  // attributes may follow
};

}  // namespace swarmanoid
