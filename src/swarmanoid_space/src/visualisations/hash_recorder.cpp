// The state hash of every tick, for comparing runs.
#include <iomanip>

#include "swarmanoid_space/output/out_file.hpp"

namespace swarmanoid {
namespace {

class HashRecorder final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "hash_recorder";
    description.summary = "Writes tick and state hash, one line a tick.";
    description.parameters = {
        makeParameter("file", Parameter::Type::kText, "", std::nullopt, {}, "Where the lines go.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    file_.open(context, parameters, id);
  }

  void draw(const Space& space) override {
    file_ << space.tick << ' ' << std::hex << std::setw(16) << std::setfill('0') << stateHash(space) << std::dec
          << '\n';
  }

  void flush() override { file_.flush(); }
  void reset() override { file_.restart(); }
  void finish() override { file_.flush(); }

 private:
  OutFile file_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::HashRecorder)
