#include "trajectory_arrays.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace swarmanoid::trajectories {
namespace {

constexpr std::size_t kPoseNumbers = 7;
constexpr std::size_t kRoomForNames = 64;  // of spawned entities [byte]; only types of fixed length can be streamed

std::size_t longestName(const Space& space) {
  std::size_t longest = kRoomForNames;
  for (const Row row : space.entities.order) {
    longest = std::max(longest, space.entities.name[row].size());
  }
  return longest;
}

ElementType textOfWidth(std::size_t width) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  check(H5Tset_size(type, width), "making the type of names");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "making the type of names");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "making the type of names");
  return {type, std::vector<std::byte>(width)};
}

template <class Number>
void appendNumber(GrowingArray& array, Number number) {
  std::memcpy(array.next(), &number, sizeof number);
  array.append();
}

void appendText(GrowingArray& array, std::size_t width, const std::string& text) {
  if (text.size() > width) {
    throw std::runtime_error("trajectories: found the name '" + text + "', allowed: up to " + std::to_string(width) +
                             " bytes for what comes while the run goes on");
  }
  std::memcpy(array.next(), text.data(), text.size());
  array.append();
}

void toNumbers(const Pose& pose, double* numbers) {
  Eigen::Map<Eigen::Vector3d>{numbers} = pose.position;
  Eigen::Map<Eigen::Vector4d>{numbers + 3} = pose.orientation.coeffs();
}

GrowingArray perRow(hid_t file, const char* name, NumberType type) { return {file, name, elementType(type), {}}; }

}  // namespace

TrajectoryArrays::TrajectoryArrays(hid_t file, const std::vector<std::string>& devices, const Space& space)
    : name_width_(longestName(space)),
      type_width_(kRoomForNames),
      time_(perRow(file, "time", NumberType::kF8)),
      tick_(perRow(file, "tick", NumberType::kU8)),
      run_(perRow(file, "run", NumberType::kU8)),
      seeds_(perRow(file, "runs/seed", NumberType::kU8)),
      first_rows_(perRow(file, "runs/first_row", NumberType::kU8)),
      names_(file, "entities/name", textOfWidth(name_width_), {}),
      types_(file, "entities/type", textOfWidth(type_width_), {}),
      are_robots_(perRow(file, "entities/is_robot", NumberType::kB1)),
      poses_([&]() -> GrowingArray {
        columns_.follow(space, 0);
        return {file, "pose", elementType(NumberType::kF8), {columns_.entities().size(), kPoseNumbers}, true};
      }()) {
  setAttribute(time_.id(), "unit", std::string("s"));
  setAttribute(poses_.id(), "unit", std::string("m; quaternion without unit"));
  setAttribute(poses_.id(), "frame", std::string("W"));
  setAttribute(poses_.id(), "numbers", std::vector<std::string>{"x", "y", "z", "qx", "qy", "qz", "qw"});
  for (const std::string& device : devices) {
    readings_.emplace_back(file, *findDeviceType(device), space, columns_.rows());
  }
  for (const Metric* metric : space.metrics) {
    metrics_.emplace_back(file, "metrics/" + metric->name, elementType(NumberType::kF8), std::vector<hsize_t>{});
    setAttribute(metrics_.back().id(), "unit", metric->unit);
    setAttribute(metrics_.back().id(), "meaning", metric->description);
  }
}

void TrajectoryArrays::append(const Space& space) {
  columns_.follow(space, time_.rows());
  appendEntities();
  appendRun(space);
  appendPoses(space);
  for (ReadingArrays& readings : readings_) {
    readings.append(space, columns_.rows());
  }
  for (std::size_t i = 0; i < metrics_.size(); ++i) {
    appendNumber(metrics_[i], space.metrics[i]->value);
  }
  constexpr double kNanosecondsInSecond = 1e9;  // a division rounds only once
  appendNumber(tick_, std::uint64_t{space.tick});
  appendNumber(run_, std::uint64_t{space.run});
  appendNumber(time_, static_cast<double>((space.time - kEpoch).count()) / kNanosecondsInSecond);
}

void TrajectoryArrays::appendEntities() {
  const std::vector<EntityColumns::Entity>& entities = columns_.entities();
  for (std::size_t column = names_.rows(); column < entities.size(); ++column) {
    appendText(names_, name_width_, entities[column].name);
    appendText(types_, type_width_, entities[column].type);
    appendNumber(are_robots_, entities[column].is_robot);
  }
  if (entities.size() > poses_.width()) {
    poses_.widen(entities.size());
  }
  for (const EntityColumns::Late& late : columns_.late()) {
    double numbers[kPoseNumbers];
    toNumbers(late.pose, numbers);
    poses_.fillBack(late.first_row, late.column, reinterpret_cast<const std::byte*>(numbers));
  }
}

void TrajectoryArrays::appendPoses(const Space& space) {
  auto* numbers = reinterpret_cast<double*>(poses_.next());
  for (const Row row : columns_.rows()) {
    if (row != kNoRow) {
      toNumbers(space.entities.pose[row], numbers);
    }
    numbers += kPoseNumbers;
  }
  poses_.append();
}

void TrajectoryArrays::appendRun(const Space& space) {
  if (seeds_.rows() == 0 || space.tick == 0) {
    appendNumber(seeds_, space.seed);
    appendNumber(first_rows_, std::uint64_t{time_.rows()});
  }
}

void TrajectoryArrays::write() {
  for (GrowingArray* array : {&names_, &types_, &are_robots_, &seeds_, &first_rows_, &poses_}) {
    array->write();
  }
  for (ReadingArrays& readings : readings_) {
    readings.write();
  }
  for (GrowingArray& metric : metrics_) {
    metric.write();
  }
  for (GrowingArray* array : {&tick_, &run_, &time_}) {
    array->write();
  }
}

}  // namespace swarmanoid::trajectories
