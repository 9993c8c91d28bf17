// The text table: every column has a name, every line a value in each of them.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "small_world.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

/// The lines that a run of the small world leaves.
std::vector<std::string> tableOf(int ticks) {
  const TemporaryFolder folder("text_render_test");
  const std::string file = folder.path() / "table.txt";
  loadPluginLibrary("swarmanoid_visualisations", {}, {});
  const auto table = makePlugin<Observer>(*Registry::instance().find(PluginKind::kObserver, "text_render"));
  Configuration parameters("text_render", "", {});
  parameters.set("file", file);
  table->configure("table", parameters, {});
  const auto simulation = test::smallWorld(ticks);
  simulation->addObserver(table);
  simulation->start();
  while (!simulation->isFinished()) {
    simulation->tick();
  }
  simulation->finish();
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return split(text.str(), '\n');
}

TEST(TextRenderTest, TheHeaderNamesTheColumnsBelowIt) {
  const std::vector<std::string> lines = tableOf(1);
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines[0], "#clock\tEntity type\tEntity id\tX\tY\tZ\tAlpha\tBeta\tGamma");
  EXPECT_EQ(lines[1], "0\tBlock\twall\t2.5\t4\t0.2\t0\t0\t30");
}

TEST(TextRenderTest, NoCellIsEmpty) {
  const std::vector<std::string> lines = tableOf(3);
  const std::size_t columns = split(lines.at(0), '\t').size();
  for (const std::string& line : lines) {
    const std::vector<std::string> cells = split(line, '\t');
    EXPECT_EQ(cells.size(), columns) << line;
    for (const std::string& cell : cells) {
      EXPECT_FALSE(cell.empty()) << line;
    }
  }
}

}  // namespace
}  // namespace swarmanoid
