// Ten thousand random robots: each is loaded, or refused for the mistake that was inserted.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <random>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

struct Mistake {
  std::string reason;  ///< part of the message; empty: none
  int line = 0;
};

/// A body, in lines 3 to 6, and an arm on a joint, in lines 7 to 11.
class RandomUrdf {
 public:
  explicit RandomUrdf(unsigned seed) : random_(seed) {
    const double mass = std::pow(10.0, uniform(-4.5, 7.5));
    text_ << "<robot name='r'>\n<swarmanoid title='Rover' summary='It roves.'/>\n<link "
             "name='base_link'>\n<inertial><mass "
             "value='"
          << mass << "'/>\n";
    writeInertia();
    text_ << "</inertial>\n<collision><geometry><box size='0.1 0.2 0.3'/></geometry></collision></link>\n";
    writeJoint();
    text_ << "<link name='arm'><collision><geometry><sphere radius='0.01'/></geometry></collision></link>\n</robot>\n";
    if (mass > 1e6) {
      expect(4, "link 'base_link': found a mass of ");  // checked before its inertia
    } else if (mass < 1e-3 && first_.reason.empty()) {
      first_ = {"found a mass of ", 0};
    }
  }

  std::string text() const { return text_.str(); }
  const Mistake& mistake() const { return first_; }

 private:
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  bool isDrawn(double chance) { return uniform(0.0, 1.0) < chance; }

  void expect(int line, const std::string& reason) {
    if (first_.reason.empty() || line < first_.line) {
      first_ = {reason, line};
    }
  }

  /// Writes the inertia of a rotated body; a third of them are negative or break the triangle inequality, by 5 % or
  /// more.
  void writeInertia() {
    Vector3d moments(uniform(0.1, 1.0), uniform(0.1, 1.0), 0.0);
    moments.z() = uniform(std::abs(moments.x() - moments.y()), moments.x() + moments.y());
    if (isDrawn(0.3)) {
      const bool is_negative = isDrawn(0.5);
      moments.z() = is_negative ? uniform(-1.0, -0.05) : uniform(1.05, 3.0) * (moments.x() + moments.y());
      expect(5, "link 'base_link': found the principal moments of inertia ");
    }
    moments *= std::pow(10.0, uniform(-6.0, 6.0));
    const Eigen::Matrix3d turn = Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))
                                     .normalized()
                                     .toRotationMatrix();
    const Eigen::Matrix3d inertia = turn * moments.asDiagonal() * turn.transpose();
    constexpr int kDigits = 4;
    const auto number = [&](int i, int j) { return shortNumber(inertia(i, j), kDigits); };
    text_ << "<inertia ixx='" << number(0, 0) << "' ixy='" << number(0, 1) << "' ixz='" << number(0, 2) << "' iyy='"
          << number(1, 1) << "' iyz='" << number(1, 2) << "' izz='" << number(2, 2) << "'/>\n";
  }

  void writeJoint() {
    const std::vector<std::string> types{"fixed", "revolute", "continuous", "prismatic", "floating", "planar"};
    const std::string type = types[static_cast<std::size_t>(uniform(0.0, 8.0)) % types.size()];
    const bool turns = type == "revolute" || type == "continuous";
    text_ << "<joint name='elbow' type='" << type << "'><origin rpy='" << uniform(-4, 4) << " " << uniform(-4, 4) << " "
          << uniform(-4, 4) << "'/>\n<parent link='base_link'/><child link='arm'/>";
    if (type == "prismatic" || type == "floating" || type == "planar") {
      expect(8, "joint 'elbow': found the type '" + type + "', allowed: fixed, revolute, continuous");
    }
    if (turns && isDrawn(0.1)) {
      text_ << "<axis xyz='0 0 0'/>";
      expect(8, "joint 'elbow': found the axis 0 0 0, allowed: a direction");
    } else {
      text_ << "<axis xyz='" << uniform(-1, 1) << " " << uniform(-1, 1) << " " << uniform(0.1, 1) << "'/>";
    }
    text_ << "<limit lower='-1' upper='1' velocity='2' effort='3'/>\n";
    if (turns && isDrawn(0.2)) {
      text_ << "<mimic joint='elbow' multiplier='2'/>";
      expect(10, "joint 'elbow': found <mimic>, allowed: joints that follow no other one");
    }
    text_ << "\n</joint>";
  }

  std::mt19937 random_;
  PlainTextStream text_;
  Mistake first_;
};

TEST(RandomUrdfTest, EachIsLoadedOrRefusedForItsFirstMistake) {
  const TemporaryFolder folder("random_urdf_test");
  const std::string file = (folder.path() / "robot.urdf").string();
  int loaded = 0;
  for (unsigned seed = 0; seed < 10000; ++seed) {
    const RandomUrdf robot(seed);
    std::ofstream(file) << robot.text();
    std::string message;
    try {
      const auto model = loadRobotModel("robot", file);
      ASSERT_GE(model->inertia.eigenvalues().real().minCoeff(), -0.02 * model->inertia.norm()) << robot.text();
      ++loaded;
    } catch (const ConfigError& error) {
      message = error.what();
    }
    const Mistake& mistake = robot.mistake();
    const std::string place = file + (mistake.line == 0 ? "" : ":" + std::to_string(mistake.line)) + ": ";
    ASSERT_EQ(message.substr(0, (place + mistake.reason).size()), mistake.reason.empty() ? "" : place + mistake.reason)
        << seed << ": " << message << "\n"
        << robot.text();
  }
  EXPECT_GT(loaded, 2000);
  EXPECT_LT(loaded, 8000);
}

}  // namespace
}  // namespace swarmanoid
