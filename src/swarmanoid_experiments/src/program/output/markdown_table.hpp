/// A Markdown table that is built row by row.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid::program {

class MarkdownTable {
 public:
  explicit MarkdownTable(const std::vector<std::string>& columns);

  /// @param cells one for each column; bars in them are escaped
  void add(const std::vector<std::string>& cells);
  /// Returns the lines.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace swarmanoid::program
