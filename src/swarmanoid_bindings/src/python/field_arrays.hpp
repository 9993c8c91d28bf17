/// The fields of a device of many robots in Python, as NumPy arrays: `readings["footbot_proximity"].value` has the
/// shape (robots, 24). Arrays of readings are read-only copies, which keep the values of their tick. Commands are
/// written as a whole, `commands["footbot_wheels"].left = speeds`, or in place, `commands["footbot_wheels"].left[some]
/// = 3.0`: a step has one array per field, and its content at the end of the step is the command. From then on, and
/// outside a step, arrays of commands are read-only copies, too.
///
/// Threads  the GIL must be held.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "moment.hpp"
#include "swarmanoid_interface/field_table.hpp"

namespace swarmanoid::bindings {

/// Addresses of records, in the order of the robots.
using Places = std::shared_ptr<const std::vector<std::byte*>>;

/// Permitted use of arrays that Python receives.
enum class ArrayUse {
  kLook,  ///< readings, and commands outside a step: read-only copies
  kWrite  ///< commands in a step: written back at its end
};

/// Devices of robots, or elements of lists in them.
struct Records {
  OfMoment moment;
  Places places;
  std::map<const FieldPlaces*, pybind11::array> written;  ///< arrays given to Python for writing, by field

  std::size_t size() const { return places->size(); }
};

/// Makes an array read-only, so that a write that would be lost raises an error. @return the array
template <class Array>
Array withoutWriting(Array array) {
  pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// An uninitialized array for a field of that many records.
pybind11::array arrayFor(const FieldPlaces& field, std::size_t records);
/// Copies a field of all records to a contiguous array, and back. @{
void gather(const std::vector<std::byte*>& records, const FieldPlaces& field, void* numbers);
void scatter(const void* numbers, const FieldPlaces& field, const std::vector<std::byte*>& records);
/// @}

/// One device of all robots, or a part of it such as `joints` of `joints.angle`.
class FieldArrays {
 public:
  /// @param device for messages @param prefix of the part: "" or "joints."
  FieldArrays(std::shared_ptr<Records> records, const FieldTable& table, std::string device, std::string prefix,
              ArrayUse use)
      : records_(std::move(records)),
        table_(&table),
        device_(std::move(device)),
        prefix_(std::move(prefix)),
        use_(use) {}

  std::size_t size() const { return records_->size(); }
  /// An array, a list or a part. @throws pybind11::attribute_error that lists the known names
  pybind11::object get(const std::string& name) const;
  /// @param value an array of the field's shape, or a value that NumPy broadcasts to it
  /// @throws pybind11::type_error if the field is not writable here, pybind11::value_error for a wrong shape or number
  void set(const std::string& name, const pybind11::object& value) const;
  /// Copies arrays written by Python to the devices, and makes these arrays read-only.
  void writeBack() const;
  std::vector<std::string> names() const { return table_->namesBehind(prefix_); }
  std::string describe() const;

 private:
  [[noreturn]] void refuse(const std::string& name) const;

  std::shared_ptr<Records> records_;
  const FieldTable* table_;
  std::string device_;
  std::string prefix_;
  ArrayUse use_;
};

/// A list such as `blobs`: the elements of all robots, concatenated in the order of robots. `counts` has the number of
/// elements per robot, `robot` the robot of each element.
class ListArrays {
 public:
  ListArrays(const Records& records, const ListPlaces& list, const std::string& device);

  pybind11::array counts() const { return counts_; }
  pybind11::array robot() const { return robot_; }
  const FieldArrays& elements() const { return elements_; }

 private:
  pybind11::array_t<std::int64_t> counts_;
  pybind11::array robot_;
  FieldArrays elements_;
};

void bindFieldArrays(pybind11::module_& module);

}  // namespace swarmanoid::bindings
