#include "state_message.hpp"

#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

class MessageVisitor final : public StateVisitor {
 public:
  MessageVisitor(const Space& space, swarmanoid_msgs::NamedState& message) : space_(space), message_(message) {}

  void beginEntity(Row row) override { owner_ = space_.entities.name[row]; }
  void beginWorld() override { owner_ = ""; }

  void number(const FieldName& name, double value) override { add(nameOf(name), value); }
  void vector(const FieldName& name, const Eigen::Vector3d& value) override {
    const std::string begin = nameOf(name);
    add(begin + "/x", value.x());
    add(begin + "/y", value.y());
    add(begin + "/z", value.z());
  }
  void quaternion(const FieldName& name, const Eigen::Quaterniond& value) override {
    vector(name, value.vec());
    add(nameOf(name) + "/w", value.w());
  }
  void colors(const FieldName& name, Span<const Color> values) override {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string begin = nameOf(name) + "/" + std::to_string(i);
      add(begin + "/red", values[i].red);
      add(begin + "/green", values[i].green);
      add(begin + "/blue", values[i].blue);
    }
  }
  void entity(const FieldName& name, Row value) override {
    text(name, value == kNoRow ? std::string_view() : std::string_view(space_.entities.name[value]));
  }
  void ordinal(std::size_t) override {}
  void text(const FieldName& name, std::string_view value) override {
    text_names_.push_back(nameOf(name));
    message_.texts.emplace_back(value);
  }
  bool wantsDetail() const override { return true; }

  /// Returns the names of numbers, then of texts.
  std::vector<std::string> takeNames() {
    names_.insert(names_.end(), text_names_.begin(), text_names_.end());
    return std::move(names_);
  }

 private:
  std::string nameOf(const FieldName& name) const {
    std::string text = owner_;
    for (const std::string_view part : {name.group, name.member, name.quantity}) {
      if (!part.empty()) {
        text += (text.empty() ? "" : "/") + std::string(part);
      }
    }
    return name.index < 0 ? text : text + "/" + std::to_string(name.index);
  }
  void add(std::string name, double value) {
    names_.push_back(std::move(name));
    message_.numbers.push_back(value);
  }

  const Space& space_;
  swarmanoid_msgs::NamedState& message_;
  std::string owner_;
  std::vector<std::string> names_;
  std::vector<std::string> text_names_;
};

}  // namespace

const swarmanoid_msgs::NamedState& StateMessage::write(const Space& space) {
  message_.header = headerOf(space);
  message_.tick = space.tick;
  message_.run = space.run;
  message_.numbers.clear();
  message_.texts.clear();
  MessageVisitor visitor(space, message_);
  visitState(space, visitor);
  std::vector<std::string> names = visitor.takeNames();
  message_.names.clear();
  if (names != names_) {
    names_ = std::move(names);
    message_.names = names_;
  }
  return message_;
}

}  // namespace swarmanoid
