#include "markdown_table.hpp"

namespace swarmanoid::program {

MarkdownTable::MarkdownTable(const std::vector<std::string>& columns) {
  add(columns);
  text_ += "|";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    text_ += "---|";
  }
  text_ += "\n";
}

void MarkdownTable::add(const std::vector<std::string>& cells) {
  text_ += "|";
  for (const std::string& cell : cells) {
    text_ += cell.empty() ? "" : " ";
    for (const char letter : cell) {
      text_ += letter == '|' ? "\\|" : std::string(1, letter);
    }
    text_ += " |";
  }
  text_ += "\n";
}

}  // namespace swarmanoid::program
