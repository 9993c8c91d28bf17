// The text table of thesis 3.6.1 and figure 3.11: one line per entity and tick, columns separated by tabs. As printed,
// the figure has the mark # of its header in a column of its own, above the ticks, and the column "clock" is empty. The
// layout `figure` reproduces this. In the layout `columns` # is part of the first name, so that every column has its
// name and every cell its value.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <string_view>

#include "swarmanoid_interface/orientation.hpp"
#include "swarmanoid_recording/output/out_file.hpp"

namespace swarmanoid {
namespace {

constexpr double kDegPerRad = 180.0 / M_PI;
constexpr const char* kColumns = "columns";
constexpr const char* kFigure = "figure";

class TextRender final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "text_render";
    description.summary = "Writes position and orientation of every entity as a plain table.";
    using Type = Parameter::Type;
    Parameter layout = makeParameter("layout", Type::kChoice, "", kColumns, {},
                                     "Each column under its name, or as figure 3.11 is printed, with its mark # in a "
                                     "column of its own.");
    layout.choices = {kColumns, kFigure};
    description.parameters = {
        makeParameter("file", Type::kText, "", "", {}, "Output file; empty: the standard error stream."),
        makeParameter("precision", Type::kInteger, "", "6", {0.0, 15.0},
                      "Decimals of each number; trailing zeros are left out."),
        makeParameter("every", Type::kInteger, "ticks", "1", {1.0, 1e9}, "Ticks from one table to the next."), layout};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    precision_ = static_cast<int>(parameters.integer("precision", std::int64_t{6}));
    has_mark_column_ = parameters.text("layout", kColumns) == kFigure;
    every_ = static_cast<std::uint64_t>(parameters.integer("every", std::int64_t{1}));
    if (!parameters.text("file", "").empty()) {
      file_.open(context, parameters, id);
    }
  }

  void draw(const Space& space) override {
    if (space.tick % every_ != 0) {
      return;
    }
    std::ostream& out = file_.isOpen() ? static_cast<std::ostream&>(file_) : std::cerr;
    if (!has_header_) {
      has_header_ = true;
      file_.describeRun(space);
      out << (has_mark_column_ ? "#\tclock" : "#clock") << "\tEntity type\tEntity id\tX\tY\tZ\tAlpha\tBeta\tGamma\n";
    }
    for (const Row row : space.entities.order) {
      writeLine(out, space, row);
    }
  }

  void flush() override { file_.flush(); }
  void finish() override { file_.describeEnd(); }

  void reset() override {
    file_.restart();
    has_header_ = false;
  }

 private:
  void writeLine(std::ostream& out, const Space& space, Row row) {
    const Entities& entities = space.entities;
    const Eigen::Vector3d& p = entities.pose[row].position;
    const Eigen::Vector3d angles = anglesFromOrientation(entities.pose[row].orientation) * kDegPerRad;
    out << space.tick << (has_mark_column_ ? "\t\t" : "\t") << entities.model[row]->title << '\t' << entities.name[row];
    for (const double value : {p.x(), p.y(), p.z(), angles.x(), angles.y(), angles.z()}) {
      out << '\t' << shortened(value);
    }
    out << '\n';
  }

  /// Returns a number in the form of figure 3.11: "9", "0.25", "45.5", "0.455".
  std::string_view shortened(double value) {
    char* const begin = std::begin(buffer_);
    char* end = std::to_chars(begin, std::end(buffer_), value, std::chars_format::fixed, precision_).ptr;
    if (std::find(begin, end, '.') != end) {
      for (; end[-1] == '0'; --end) {
      }
      end -= end[-1] == '.' ? 1 : 0;
    }
    const std::string_view text(begin, static_cast<std::size_t>(end - begin));
    return text == "-0" ? "0" : text;
  }

  OutFile file_;
  int precision_ = 6;
  std::uint64_t every_ = 1;
  bool has_header_ = false;
  bool has_mark_column_ = false;
  char buffer_[std::numeric_limits<double>::max_exponent10 + 20] = {};
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::TextRender)
