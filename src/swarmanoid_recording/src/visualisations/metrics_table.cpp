// Writes the metrics of all rules as a table of comma-separated values, for plots and statistics.
#include <charconv>

#include "swarmanoid_recording/output/out_file.hpp"

namespace swarmanoid {
namespace {

class MetricsTable final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "metrics_table";
    description.summary =
        "Writes the metrics of all rules as comma-separated values: the run after a #, a header, then a row a tick.";
    description.parameters = {
        makeParameter("file", Parameter::Type::kText, "", std::nullopt, {}, "Output file."),
        makeParameter("every", Parameter::Type::kInteger, "ticks", "1", {1.0, 1e9}, "Ticks from one row to the next.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    every_ = static_cast<std::uint64_t>(parameters.integer("every", std::int64_t{1}));
    file_.open(context, parameters, id);
  }

  void draw(const Space& space) override {
    if (!has_header_) {
      has_header_ = true;
      writeHeader(space);
    }
    if (space.tick % every_ == 0) {
      writeRow(space);
    }
  }

  void flush() override { file_.flush(); }
  void finish() override { file_.describeEnd(); }

  void reset() override {
    file_.restart();
    has_header_ = false;
  }

 private:
  void writeHeader(const Space& space) {
    file_.describeRun(space);
    file_ << "tick,time";
    for (const Metric* metric : space.metrics) {
      file_ << ',' << metric->name;
    }
    file_ << '\n';
  }

  void writeRow(const Space& space) {
    file_ << space.tick << ',';
    constexpr double kNanosecondsInSecond = 1e9;  // a division rounds only once: 0.3 and not 0.30000000000000004
    write(static_cast<double>((space.time - kEpoch).count()) / kNanosecondsInSecond);
    for (const Metric* metric : space.metrics) {
      file_ << ',';
      write(metric->value);
    }
    file_ << '\n';
  }

  /// Writes the shortest text that is read back as this number.
  void write(double value) {
    char text[32];
    file_.write(text, std::to_chars(std::begin(text), std::end(text), value).ptr - text);
  }

  OutFile file_;
  std::uint64_t every_ = 1;
  bool has_header_ = false;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::MetricsTable)
