// What controllers say with robot.debug, and the events of the run: one line a change, columns separated by tabs.
#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "swarmanoid_space/visualisation.hpp"

namespace swarmanoid {
namespace {

class DebugRender final : public Visualisation {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "debug_render";
    description.summary = "Writes events, and the controllers' debug values whenever they change.";
    Parameter file;
    file.name = "file";
    file.description = "Where the lines go.";
    description.parameters = {file};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    path_ = std::filesystem::path(context.out_folder) / parameters.text("file");
    open(parameters.location());
  }

  void draw(const Space& space) override {
    for (const Event& event : space.events) {
      file_ << space.tick << '\t' << event.entity << '\t' << toString(event.kind) << '\t' << event.other
            << (event.other.empty() || event.text.empty() ? "" : " ") << event.text << '\n';
    }
    for (const Row row : space.entities.order) {
      const auto& robot = space.robots[static_cast<std::size_t>(row)];
      if (robot) {
        writeChanges(space.tick, *robot);
      }
    }
  }

  void reset() override {
    file_.close();
    open({});
    known_.clear();
  }

  void finish() override {
    file_.flush();
    if (!file_) {
      throw std::runtime_error("debug_render '" + id_ + "': writing " + path_.string() + " failed");
    }
  }

 private:
  void open(const SourceLocation& location) {
    file_.open(path_, std::ios::trunc);
    if (!file_) {
      throw ConfigError(location, "debug_render '" + id_ + "': cannot write " + path_.string());
    }
    file_ << "#clock\tEntity id\tKey\tValue\n";
  }

  void writeChanges(std::uint64_t tick, const Robot& robot) {
    for (const auto& [key, value] : robot.debugValues()) {
      std::string& known = known_[{robot.name(), key}];
      if (known != value) {
        known = value;
        file_ << tick << '\t' << robot.name() << '\t' << key << '\t' << value << '\n';
      }
    }
  }

  std::filesystem::path path_;
  std::ofstream file_;
  std::map<std::pair<std::string, std::string>, std::string> known_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_VISUALISATION(swarmanoid::DebugRender)
