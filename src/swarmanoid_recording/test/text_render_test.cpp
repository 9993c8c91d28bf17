// The text table: every column has a name, every line has a value in each of them.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/small_world.hpp"
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

/// Returns the lines that a run writes.
std::vector<std::string> tableOf(Simulation& simulation, const std::map<std::string, std::string>& values) {
  const TemporaryFolder folder("text_render_test");
  const std::string file = folder.path() / "table.txt";
  loadPluginLibrary("swarmanoid_visualisations", {}, {});
  const auto table = makePlugin<Observer>(*Registry::instance().find(PluginKind::kObserver, "text_render"));
  Configuration parameters("text_render", "", {});
  parameters.set("file", file);
  for (const auto& [name, value] : values) {
    parameters.set(name, value);
  }
  table->configure("table", parameters, {});
  simulation.addObserver(table);
  simulation.start();
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  simulation.finish();
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return split(text.str(), '\n');
}

std::vector<std::string> tableOf(int ticks, const std::map<std::string, std::string>& values = {}) {
  return tableOf(*test::smallWorld(ticks), values);
}

TEST(TextRenderTest, TheHeaderNamesTheColumnsBelowIt) {
  const std::vector<std::string> lines = tableOf(1);
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines[0], "#clock\tEntity type\tEntity id\tX\tY\tZ\tAlpha\tBeta\tGamma");
  EXPECT_EQ(lines[1], "0\tBlock\twall\t2.5\t4\t0.2\t0\t0\t30");
}

TEST(TextRenderTest, InTheLayoutOfTheFigureTheMarkHasAColumnOfItsOwn) {
  const std::vector<std::string> lines = tableOf(1, {{"layout", "figure"}});
  EXPECT_EQ(lines[0], "#\tclock\tEntity type\tEntity id\tX\tY\tZ\tAlpha\tBeta\tGamma");
  EXPECT_EQ(lines[1], "0\t\tBlock\twall\t2.5\t4\t0.2\t0\t0\t30");
}

TEST(TextRenderTest, PrecisionIsThatOfDecimals) {
  const std::string text = R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>1</maxclock></framework>
  <arena size="200,5,3" optimization="2D">
    <light id="lamp"><position>131.2649, 0.004, 2.5</position><orientation>0, 0, -0.004</orientation></light>
  </arena></ahss-config>)";
  const auto line = [&](const std::string& decimals) {
    Simulation simulation(parseExperiment(text, "lamp.xml"));
    return tableOf(simulation, {{"precision", decimals}})[1];
  };
  EXPECT_EQ(line("2"), "0\tLight\tlamp\t131.26\t0\t2.5\t0\t0\t0");
  EXPECT_EQ(line("0"), "0\tLight\tlamp\t131\t0\t2\t0\t0\t0");
  EXPECT_EQ(line("4"), "0\tLight\tlamp\t131.2649\t0.004\t2.5\t0\t0\t-0.004");
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
