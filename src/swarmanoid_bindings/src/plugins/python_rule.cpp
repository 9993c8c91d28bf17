#include "python_rule.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "python/archive_object.hpp"
#include "python/errors.hpp"
#include "python/python_lock.hpp"
#include "python/python_parameters.hpp"
#include "rule_world.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

constexpr std::array<const char*, 7> kHooks{"init",     "reset",   "before_tick", "after_tick",
                                            "finished", "success", "metrics"};

bool isTrue(const py::object& value) {
  const int truth = PyObject_IsTrue(value.ptr());
  if (truth < 0) {
    throw py::error_already_set();
  }
  return truth != 0;
}

double numberOf(const py::handle& value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() != nullptr) {
    throw py::error_already_set();
  }
  return number;
}

std::string withoutRuleName(const std::string& metric, const std::string& rule) {
  return metric.substr(rule.size() + 1);
}

[[noreturn]] void refuse(PyObject* type, const std::string& text) {
  PyErr_SetString(type, text.c_str());
  throw py::error_already_set();
}

}  // namespace

PythonRule::PythonRule(py::object rule, std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown)
    : rule_(std::move(rule)), moment_(std::move(moment)), thrown_(std::move(thrown)) {
  const bool is_class = PyType_Check(rule_.ptr()) != 0;
  const auto has = [&](const char* hook) { return py::hasattr(rule_, hook); };
  if (is_class || std::none_of(kHooks.begin(), kHooks.end(), has)) {
    throw py::type_error("found a rule " + std::string(py::repr(rule_)) + ", allowed: an object with functions of " +
                         joinNames({kHooks.begin(), kHooks.end()}));
  }
}

/// Runs an action with the GIL. Python exceptions are kept, and reported to the caller as std::runtime_error.
template <class Action>
void PythonRule::call(const char* hook, Action action) {
  const PythonLock lock;
  if (thrown_->isOver()) {
    return;
  }
  const Pause pause(*moment_);
  try {
    action();
  } catch (py::error_already_set& error) {
    const std::string text = "rule '" + id() + "', " + hook + ": " + describe(error);
    if (thrown_->keep(std::move(error), text)) {
      throw std::runtime_error(text);
    }
  }
}

void PythonRule::configure(const Configuration& parameters) {
  call("init", [&] {
    if (py::hasattr(rule_, "init")) {
      rule_.attr("init")(parametersOf(parameters));
    }
  });
  call("metrics", [&] {
    if (py::hasattr(rule_, "metrics")) {
      for (const auto& [name, value] : py::dict(rule_.attr("metrics")())) {
        own_metrics_.push_back(&addMetric(py::str(name), "", ""));
      }
    }
  });
}

void PythonRule::reset(const Space& space, InterventionQueue& queue) {
  is_finished_ = false;
  success_.reset();
  callWith("reset", space, queue);
  judge();
  is_finished_ = false;  // a run has at least one tick, as with C++ rules
}

void PythonRule::beforeTick(const Space& space, InterventionQueue& queue) { callWith("before_tick", space, queue); }

void PythonRule::afterTick(const Space& space, InterventionQueue& queue) {
  callWith("after_tick", space, queue);
  judge();
}

void PythonRule::archive(StateArchive& state) {
  const PythonLock lock;
  archiveObject(state, rule_);
  state(is_finished_, success_);
}

void PythonRule::callWith(const char* hook, const Space& space, InterventionQueue& queue) {
  call(hook, [&] {
    if (py::hasattr(rule_, hook)) {
      rule_.attr(hook)(RuleWorld(space, queue, random(), moment_));
    }
  });
}

void PythonRule::judge() {
  call("metrics", [&] { takeMetrics(); });
  call("finished", [&] { is_finished_ = py::hasattr(rule_, "finished") && isTrue(rule_.attr("finished")()); });
  call("success", [&] {
    const py::object success = py::hasattr(rule_, "success") ? rule_.attr("success")() : py::none();
    success_ = success.is_none() ? std::nullopt : std::optional<bool>(isTrue(success));
  });
}

void PythonRule::takeMetrics() {
  if (!py::hasattr(rule_, "metrics")) {
    return;
  }
  const py::object found = rule_.attr("metrics")();
  std::vector<std::string> names;
  for (const Metric* metric : own_metrics_) {
    names.push_back(withoutRuleName(metric->name, id()));
  }
  if (!py::isinstance<py::dict>(found) || py::len(found) != names.size()) {
    refuse(PyExc_ValueError, "found " + std::string(py::repr(found)) +
                                 ", allowed: a dictionary with the names of the start: " + joinNames(names));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    own_metrics_[i]->value = numberOf(py::object(found[py::str(names[i])]));
  }
}

}  // namespace swarmanoid::bindings
