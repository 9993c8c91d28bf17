// The conformance test: a controller that tests the devices of its robot one after the other, and judges by the
// readings of the robot's own sensors whether units and signs match the interface. After a failure it stops the robot,
// unless it is an observer.
#include <algorithm>
#include <stdexcept>

#include "checks.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid::conformance {

class Conformance final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    bench_ = std::make_unique<Bench>(robot, parameters);
    reset();
  }

  void reset() override {
    checks_ = checksFor(*bench_);  // rebuilt, because checks keep readings
    current_ = 0;
    stage_ = 0;
    is_begun_ = false;
    is_over_ = false;
    results_.clear();
    bench_->robot().debug("conformance", "running");
  }

  void step(Time time, Duration) override {
    const double now = toSeconds(time);
    for (const Check& check : checks_) {
      if (check.always) {
        check.always();
      }
    }
    while (!is_over_) {
      if (current_ == checks_.size()) {
        conclude();
        return;
      }
      const Check& check = checks_[current_];
      if (!is_begun_ && stage_ == 0) {
        const std::string obstacle = obstacleOf(check);
        if (!obstacle.empty()) {
          results_.push_back({Outcome::kUnchecked, obstacle});
          ++current_;
          continue;
        }
        bench_->startCheck(check.name);
        bench_->robot().debug("check", check.name);
      }
      if (!advance(check, now)) {
        return;
      }
    }
  }

 private:
  enum class Outcome { kPassed, kFailed, kUnchecked };
  struct Result {
    Outcome outcome;
    std::string text;
  };

  /// @return whether the stage is over, so that the next one starts in this tick
  bool advance(const Check& check, double now) {
    const Stage& stage = check.stages[stage_];
    if (!is_begun_) {
      is_begun_ = true;
      stage_start_ = now;
      if (stage.begin) {
        stage.begin();
      }
    }
    constexpr double kRounding = 1e-6;  // s
    const double elapsed = now - stage_start_;
    const bool is_time_out = elapsed >= stage.seconds - kRounding;
    const bool is_done = stage.until ? stage.until() : is_time_out;
    if (bench_->failure().empty() && !is_done) {
      if (is_time_out) {
        bench_->fail(stage.what + ": not within " + withUnit(stage.seconds, "s"));
      } else {
        if (stage.act) {
          stage.act();
        }
        return false;
      }
    }
    if (bench_->failure().empty() && stage.end) {
      stage.end(elapsed);
    }
    is_begun_ = false;
    ++stage_;
    if (!bench_->failure().empty() || stage_ == check.stages.size()) {
      bench_->rest();
      if (!bench_->failure().empty() && check.tidy_up) {
        check.tidy_up();
      }
      results_.push_back({bench_->failure().empty() ? Outcome::kPassed : Outcome::kFailed, bench_->failure()});
      ++current_;
      stage_ = 0;
    }
    return true;
  }

  std::string obstacleOf(const Check& check) const {
    std::vector<std::string> missing;
    for (const std::string& device : check.devices) {
      if (!bench_->isListed(device)) {
        missing.push_back(device);
      }
    }
    if (!missing.empty()) {
      return "not listed: " + joinNames(missing);
    }
    if (!check.obstacle.empty()) {
      return check.obstacle;
    }
    for (std::size_t i = 0; i < results_.size(); ++i) {
      const std::string& name = checks_[i].name;
      if (contains(check.after, name) && results_[i].outcome != Outcome::kPassed) {
        return "it needs " + name + ", which has not passed";
      }
      if (contains(check.trusts, name) && results_[i].outcome == Outcome::kFailed) {
        return "it needs " + name + ", which has failed";
      }
    }
    return "";
  }

  /// Returns the devices without a completed check, so that each of them is reported.
  std::vector<std::string> uncovered() const {
    std::vector<std::string> left;
    for (const DeviceType* type : deviceTypes()) {
      bool is_covered = !bench_->isListed(type->type);
      for (std::size_t i = 0; i < checks_.size(); ++i) {
        const std::vector<std::string>& devices = checks_[i].devices;
        is_covered = is_covered || (results_[i].outcome != Outcome::kUnchecked && !checks_[i].is_only_shown &&
                                    std::find(devices.begin(), devices.end(), type->type) != devices.end());
      }
      if (!is_covered) {
        left.push_back(type->type);
      }
    }
    return left;
  }

  struct Summary {
    std::vector<std::string> passed;
    std::vector<std::string> failed;
    std::string why;        ///< all failures
    std::string unchecked;  ///< skipped checks, each with the reason
    bool has_judged = false;
  };

  Summary summary() const {
    const auto append = [](std::string& text, const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
    Summary summary;
    for (std::size_t i = 0; i < checks_.size(); ++i) {
      const Check& check = checks_[i];
      const Result& result = results_[i];
      if (result.outcome == Outcome::kFailed) {
        summary.failed.push_back(check.name);
        append(summary.why, check.name + ": " + result.text);
      } else if (result.outcome == Outcome::kUnchecked) {
        append(summary.unchecked, check.name + " (" + result.text + ")");
      } else {
        summary.has_judged = summary.has_judged || !check.is_only_shown;
        summary.passed.push_back(check.name + (check.is_only_shown ? " (an observer judges)" : ""));
      }
    }
    if (summary.failed.empty() && !summary.has_judged) {
      summary.failed = {"nothing could be checked"};
      summary.why = summary.unchecked;
    }
    return summary;
  }

  void conclude() {
    is_over_ = true;
    bench_->rest();
    const auto orNone = [](const std::string& text) { return text.empty() ? "none" : text; };
    const Summary result = summary();
    const std::string passed = orNone(joinNames(result.passed));
    const std::string unchecked_devices = orNone(joinNames(uncovered()));
    Robot& robot = bench_->robot();
    robot.debug("passed", passed);
    robot.debug("unchecked", orNone(result.unchecked));
    robot.debug("unchecked_devices", unchecked_devices);
    if (!result.unchecked.empty()) {
      robot.log(LogLevel::kWarning, "unchecked: " + result.unchecked);
    }
    robot.log("passed: " + passed + "; devices that are listed but unchecked: " + unchecked_devices);
    if (result.failed.empty()) {
      robot.debug("conformance", "passed");
      return;
    }
    const std::string verdict = "conformance test failed: " + joinNames(result.failed) + " (" + result.why + ")";
    if (bench_->isObserver()) {  // the other robot may still call it
      robot.log(LogLevel::kError, verdict);
      robot.debug("conformance", verdict);
      return;
    }
    robot.debug("conformance", "failed: " + joinNames(result.failed));
    throw std::runtime_error(verdict);
  }

  std::unique_ptr<Bench> bench_;
  std::vector<Check> checks_;
  std::vector<Result> results_;  // results of the checks done so far
  std::size_t current_ = 0;
  std::size_t stage_ = 0;  // stage of the current check
  bool is_begun_ = false;  // whether that stage has begun
  double stage_start_ = 0.0;
  bool is_over_ = false;
};

}  // namespace swarmanoid::conformance

REGISTER_CONTROLLER(swarmanoid::conformance::Conformance, "conformance")
