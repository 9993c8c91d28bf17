// Debug values of controllers (robot.debug), and the events of the run: one line per change, columns separated by tabs.
#include <map>
#include <utility>

#include "swarmanoid_recording/output/out_file.hpp"

namespace swarmanoid {
namespace {

class DebugRender final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "debug_render";
    description.summary = "Writes events, and the controllers' debug values whenever they change.";
    description.parameters = {
        makeParameter("file", Parameter::Type::kText, "", std::nullopt, {}, "Where the lines go.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    file_.open(context, parameters, id);
  }

  void draw(const Space& space) override {
    if (!has_header_) {
      has_header_ = true;
      file_.describeRun(space);
      file_ << "#clock\tEntity id\tKey\tValue\n";
    }
    for (const Event& event : space.events) {
      file_ << space.tick << '\t' << event.entity << '\t' << toString(event.kind) << '\t' << event.other
            << (event.other.empty() || event.text.empty() ? "" : " ") << event.text << '\n';
    }
    for (const Row row : space.entities.order) {
      const auto& robot = space.robots[row];
      if (robot) {
        writeChanges(space.tick, *robot);
      }
    }
  }

  void flush() override { file_.flush(); }
  void finish() override { file_.describeEnd(); }

  void reset() override {
    file_.restart();
    has_header_ = false;
    known_.clear();
  }

 private:
  void writeChanges(std::uint64_t tick, const Robot& robot) {
    for (const auto& [key, value] : robot.debugValues()) {
      std::string& known = known_[{robot.name(), key}];
      if (known != value) {
        known = value;
        file_ << tick << '\t' << robot.name() << '\t' << key << '\t' << value << '\n';
      }
    }
  }

  OutFile file_;
  bool has_header_ = false;
  std::map<std::pair<std::string, std::string>, std::string> known_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::DebugRender)
