// The state hash of every tick, for comparing runs.

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_recording/output/out_file.hpp"

namespace swarmanoid {
namespace {

class HashRecorder final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "hash_recorder";
    description.summary = "Writes tick and state hash, one line a tick.";
    description.parameters = {
        makeParameter("file", Parameter::Type::kText, "", std::nullopt, {}, "Where the lines go."),
        makeParameter("deep", Parameter::Type::kBoolean, "", "false", {},
                      "Whether a hash of all readings and commands, too, follows in each line.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    is_deep_ = parameters.boolean("deep", false);
    file_.open(context, parameters, id);
  }

  void draw(const Space& space) override {
    file_ << space.tick;
    write(stateHash(space));
    if (is_deep_) {
      write(deepHash(space));
    }
    file_ << '\n';
  }

  void flush() override { file_.flush(); }
  void reset() override { file_.restart(); }
  void finish() override { file_.flush(); }

 private:
  void write(std::uint64_t hash) { file_ << ' ' << hashText(hash); }

  OutFile file_;
  bool is_deep_ = false;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::HashRecorder)
