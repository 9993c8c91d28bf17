#include "state_message.hpp"

#include "../../visit_state.hpp"
#include "swarmanoid_space/ros/world_state.hpp"

namespace swarmanoid {
namespace {

class MessageVisitor {
 public:
  MessageVisitor(const Space& space, swarmanoid_msgs::NamedState& message) : space_(space), message_(message) {}

  void beginEntity(Row row) { owner_ = space_.entities.name[static_cast<std::size_t>(row)]; }
  void beginWorld() { owner_ = ""; }

  template <class Value>
  void number(const FieldName& name, Value value) {
    add(nameOf(name), static_cast<double>(value));
  }
  void vector(const FieldName& name, const Eigen::Vector3d& value) {
    const std::string begin = nameOf(name);
    add(begin + "/x", value.x());
    add(begin + "/y", value.y());
    add(begin + "/z", value.z());
  }
  void quaternion(const FieldName& name, const Eigen::Quaterniond& value) {
    vector(name, value.vec());
    add(nameOf(name) + "/w", value.w());
  }
  void colors(const FieldName& name, const Color* first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::string begin = nameOf(name) + "/" + std::to_string(i);
      add(begin + "/red", first[i].red);
      add(begin + "/green", first[i].green);
      add(begin + "/blue", first[i].blue);
    }
  }
  void entity(const FieldName& name, EntityNumber number) {
    const Row row = number == kNoEntity ? kNoRow : space_.entities.find(number);
    text(name, row == kNoRow ? std::string() : space_.entities.name[static_cast<std::size_t>(row)]);
  }
  void ordinal(std::uint64_t) {}
  void text(const FieldName& name, const std::string& value) {
    text_names_.push_back(nameOf(name));
    message_.texts.push_back(value);
  }
  MessageVisitor* detail() { return this; }

  /// Of numbers, then of texts.
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
  StateVisit(space, visitor).run();
  std::vector<std::string> names = visitor.takeNames();
  message_.names.clear();
  if (names != names_) {
    names_ = std::move(names);
    message_.names = names_;
  }
  return message_;
}

}  // namespace swarmanoid
