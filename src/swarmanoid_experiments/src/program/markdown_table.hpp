/// A table of Markdown, row by row.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid::program {

class MarkdownTable {
 public:
  explicit MarkdownTable(const std::vector<std::string>& columns);

  /// @param cells as many as there are columns; a bar in one is written so that it does not end the cell
  void add(const std::vector<std::string>& cells);
  /// Returns the lines.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace swarmanoid::program
