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
    const auto path = std::filesystem::path(context.out_folder) / parameters.text("file");
    file_.open(path, std::ios::trunc);
    if (!file_) {
      throw ConfigError(parameters.location(), "hash_recorder '" + id + "': cannot write " + path.string());
    }
  }

  void draw(const Space& space) override {
    file_ << space.tick << ' ' << std::hex << std::setw(16) << std::setfill('0') << stateHash(space) << std::dec
          << '\n';
  }

  void finish() override { file_.flush(); }

 private:
  std::ofstream file_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_VISUALISATION(swarmanoid::HashRecorder)
