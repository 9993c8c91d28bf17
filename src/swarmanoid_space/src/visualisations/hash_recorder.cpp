// The state hash of every tick, for comparing runs.
#include <filesystem>
#include <fstream>
#include <iomanip>

#include "swarmanoid_space/visualisation.hpp"

namespace swarmanoid {
namespace {

class HashRecorder final : public Visualisation {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "hash_recorder";
    description.summary = "Writes tick and state hash, one line a tick.";
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
    file_ << space.tick << ' ' << std::hex << std::setw(16) << std::setfill('0') << stateHash(space) << std::dec
          << '\n';
  }

  void reset() override {
    file_.close();
    open({});
  }

  void finish() override {
    file_.flush();
    if (!file_) {
      throw std::runtime_error("hash_recorder '" + id_ + "': writing " + path_.string() + " failed");
    }
  }

 private:
  void open(const SourceLocation& location) {
    file_.open(path_, std::ios::trunc);
    if (!file_) {
      throw ConfigError(location, "hash_recorder '" + id_ + "': cannot write " + path_.string());
    }
  }

  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_VISUALISATION(swarmanoid::HashRecorder)
