/// Sections of reference pages, for tests that compare them with the code.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace swarmanoid::test {

/// The sections of all pages in a folder by name, each without its heading. The page x.md that begins with `# x` is one
/// section; any other page has a section after each heading `## name`.
inline std::unordered_map<std::string, std::string> pageSections(const std::filesystem::path& folder) {
  std::unordered_map<std::string, std::string> sections;
  const auto add = [&sections](const std::string& name, const std::string& text) {
    if (!sections.emplace(name, text).second) {
      throw std::runtime_error("two sections '" + name + "'");
    }
  };
  for (const auto& page : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(page.path());
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::string name = page.path().stem().string();
    const std::string title = "# " + name + "\n";
    if (text.rfind(title, 0) == 0) {
      add(name, text.substr(title.size()));
      continue;
    }
    const std::string start = "\n## ";
    std::size_t at = text.find(start);
    while (at != std::string::npos) {
      const std::size_t begin = at + start.size();
      const std::size_t next = text.find(start, begin);
      const std::string section = text.substr(begin, next == std::string::npos ? next : next + 1 - begin);
      const std::size_t end_of_line = section.find('\n');
      add(section.substr(0, end_of_line), end_of_line == std::string::npos ? "" : section.substr(end_of_line + 1));
      at = next;
    }
  }
  return sections;
}

}  // namespace swarmanoid::test
