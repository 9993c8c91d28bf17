#include "swarmanoid_experiment_files/robots/read_urdf.hpp"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <mutex>
#include <thread>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/read_file.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

/// Collects urdfdom's error messages: for many of them it still succeeds, without the element in question. Messages of
/// other threads go to the previous handler.
class ErrorListener : public console_bridge::OutputHandler {
 public:
  ErrorListener() : thread_(std::this_thread::get_id()), others_(console_bridge::getOutputHandler()) {
    console_bridge::useOutputHandler(this);
  }
  ~ErrorListener() override { console_bridge::useOutputHandler(others_); }
  ErrorListener(const ErrorListener&) = delete;
  ErrorListener& operator=(const ErrorListener&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) override {
    if (std::this_thread::get_id() != thread_) {
      if (others_ != nullptr) {
        others_->log(text, level, file, line);
      }
    } else if (level == console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
      errors_ += (errors_.empty() ? "" : "; ") + text;
    }
  }

  const std::string& errors() const { return errors_; }

 private:
  std::thread::id thread_;
  console_bridge::OutputHandler* others_;
  std::string errors_;
};

}  // namespace

void UrdfFile::fail(const std::string& message) const { throw ConfigError({file}, message); }

std::string readUrdfText(const std::string& file) {
  std::string text = readFile(file, limits::kLongestText);
  if (text.empty()) {
    throw ConfigError({file}, "found an empty file, allowed: XML");
  }
  return text;
}

UrdfFile readUrdf(const std::string& file) {
  static std::mutex one_listener;
  UrdfFile result;
  result.file = file;
  result.text = readUrdfText(file);
  result.document = parseXml(result.text, file,
                             XmlNamespaces::kAllowed);  // urdfdom's own parser reports neither mistake nor line
  const std::lock_guard<std::mutex> lock(one_listener);
  const ErrorListener listener;
  result.robot = urdf::parseURDF(result.text);
  if (result.robot == nullptr || !listener.errors().empty()) {
    result.fail("is not a valid URDF: " + listener.errors());
  }
  return result;
}

Mount toMount(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  Mount mount;
  mount.position = {pose.position.x, pose.position.y, pose.position.z};
  mount.orientation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
  const Eigen::Matrix3d turn = mount.orientation.toRotationMatrix();
  Eigen::Matrix3d quarters;
  for (int i = 0; i < 3; ++i) {
    quarters.col(i) = toAxis(turn.col(i), 2.0 * kSameDirection);  // the sum of the errors of three angles
  }
  constexpr double kRounding = 1e-14;  // more exact turns keep their bits
  const bool are_quarters = quarters.cwiseAbs().sum() == 3.0 && quarters.determinant() == 1.0;
  if (are_quarters && !turn.isApprox(quarters, kRounding)) {
    mount.orientation = Eigen::Quaterniond(quarters);
  }
  return mount;
}

Eigen::Vector3d toAxis(const Eigen::Vector3d& direction, double tolerance) {
  const Eigen::Vector3d straight = direction.normalized();
  const Eigen::Vector3d axis = straight.array().round() + 0.0;  // replaces -0 by 0
  return (straight - axis).norm() < tolerance ? axis : straight;
}

Eigen::Matrix3d inertiaOf(const urdf::Inertial& inertial) {
  Eigen::Matrix3d inertia;
  inertia << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,         //
      inertial.ixz, inertial.iyz, inertial.izz;
  return inertia;
}

Mount chain(const Mount& frame, const Mount& inner) {
  Mount result;
  result.position = frame.position + frame.orientation * inner.position;
  result.orientation = (frame.orientation * inner.orientation).normalized();
  return result;
}

Mount inverse(const Mount& frame) {
  Mount result;
  result.orientation = frame.orientation.conjugate();
  result.position = -(result.orientation * frame.position);
  return result;
}

std::string coordinates(const Eigen::Vector3d& v) {
  PlainTextStream stream;
  stream << v.x() << " " << v.y() << " " << v.z();
  return stream.str();
}

}  // namespace swarmanoid
