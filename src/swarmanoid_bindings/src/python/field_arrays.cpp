#include "field_arrays.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "plugins/object_rules.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

py::dtype dtypeOf(NumberType type) {
  return withNumberType(type, [](auto zero) { return py::dtype::of<decltype(zero)>(); });
}

std::vector<py::ssize_t> shapeOf(const FieldPlaces& field, std::size_t records) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(records)};
  for (const std::size_t length : field.shape) {
    shape.push_back(static_cast<py::ssize_t>(length));
  }
  return shape;
}

/// Calls copy(number of bytes). The common sizes of a single number are passed as compile-time constants.
template <class Copy>
void withSize(std::size_t size, Copy copy) {
  if (size == sizeof(double)) {
    copy(std::integral_constant<std::size_t, sizeof(double)>{});
  } else if (size == sizeof(float)) {
    copy(std::integral_constant<std::size_t, sizeof(float)>{});
  } else {
    copy(size);
  }
}

std::string textOf(const py::handle& object) { return py::str(object); }

/// Whether the value is a contiguous array of that type and shape, so that no conversion is needed.
bool isReady(const py::object& value, const py::dtype& wanted, const FieldPlaces& field, std::size_t records) {
  if (!py::isinstance<py::array>(value)) {
    return false;
  }
  const auto array = py::reinterpret_borrow<py::array>(value);
  const std::vector<py::ssize_t> shape = shapeOf(field, records);
  return array.dtype().is(wanted) && (array.flags() & py::array::c_style) != 0 &&
         std::equal(shape.begin(), shape.end(), array.shape(), array.shape() + array.ndim());
}

/// Converts the caller's value to the field's type and shape.
/// @throws py::value_error if the type cannot represent it
py::array convert(const py::object& value, const FieldPlaces& field, std::size_t records, const std::string& name) {
  const py::dtype wanted = dtypeOf(field.type);
  if (isReady(value, wanted, field, records)) {
    return py::reinterpret_borrow<py::array>(value);
  }
  const py::module_ numpy = py::module_::import("numpy");
  const py::array given = numpy.attr("asarray")(value);
  const char kind = given.dtype().kind();
  if (kind != 'b' && kind != 'i' && kind != 'u' && kind != 'f') {
    throw py::type_error(name + ": found " + textOf(given.dtype()) + ", allowed: numbers");
  }
  const py::array converted = given.dtype().is(wanted) ? given : py::array(given.attr("astype")(wanted));
  const bool is_real = field.type == NumberType::kF4 || field.type == NumberType::kF8;
  if (!is_real && !numpy.attr("array_equal")(converted, given).cast<bool>()) {
    throw py::value_error(name + ": found numbers that are no " + textOf(wanted));
  }
  try {
    return numpy.attr("ascontiguousarray")(numpy.attr("broadcast_to")(converted, shapeOf(field, records)));
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) {
      throw;
    }
    throw py::value_error(name + ": found the shape " + textOf(given.attr("shape")) + ", allowed: " +
                          textOf(py::tuple(py::cast(shapeOf(field, records)))) + " or what becomes that");
  }
}

std::vector<std::byte*> elementsOf(const Records& records, const ListPlaces& list, std::int64_t* counts) {
  std::vector<std::byte*> places;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Span<const std::byte> bytes = list.access.bytes((*records.places)[i] + list.offset);
    const std::size_t count = bytes.size() / list.access.element_size;
    counts[i] = static_cast<std::int64_t>(count);
    for (std::size_t k = 0; k < count; ++k) {
      // elements are only read
      places.push_back(const_cast<std::byte*>(bytes.data()) + k * list.access.element_size);
    }
  }
  return places;
}

FieldArrays elementArrays(const Records& records, const ListPlaces& list, const std::string& device,
                          std::int64_t* counts) {
  auto elements = std::make_shared<Records>(
      Records{records.moment, std::make_shared<std::vector<std::byte*>>(elementsOf(records, list, counts)), {}});
  return {std::move(elements), list.elements, device + "." + list.name, "", ArrayUse::kLook};
}

/// Whether an array still has the field's type and size: Python code can change its shape.
bool isWhole(const py::array& array, const FieldPlaces& field, std::size_t records) {
  return array.dtype().is(dtypeOf(field.type)) && (array.flags() & py::array::c_style) != 0 &&
         static_cast<std::size_t>(array.size()) == records * field.offsets.size();
}

/// @return a field, a list or a part. Lists and parts refer to the run, so they keep their owner alive.
py::object partOf(const py::object& owner, const FieldArrays& arrays, const std::string& name) {
  py::object part = arrays.get(name);
  if (!py::isinstance<py::array>(part)) {
    py::detail::keep_alive_impl(part, owner);
  }
  return part;
}

}  // namespace

py::array arrayFor(const FieldPlaces& field, std::size_t records) {
  return {dtypeOf(field.type), shapeOf(field, records)};
}

void gather(const std::vector<std::byte*>& records, const FieldPlaces& field, void* numbers) {
  auto* to = static_cast<std::byte*>(numbers);
  const std::size_t stride = field.offsets.size() * sizeOf(field.type);
  for (const FieldPlaces::Piece& piece : field.pieces) {
    withSize(piece.size, [&](auto size) {
      std::byte* line = to;
      for (const std::byte* record : records) {
        std::memcpy(line, record + piece.offset, size);
        line += stride;
      }
    });
    to += piece.size;
  }
}

void scatter(const void* numbers, const FieldPlaces& field, const std::vector<std::byte*>& records) {
  const auto* from = static_cast<const std::byte*>(numbers);
  const std::size_t stride = field.offsets.size() * sizeOf(field.type);
  for (const FieldPlaces::Piece& piece : field.pieces) {
    withSize(piece.size, [&](auto size) {
      const std::byte* line = from;
      for (std::byte* record : records) {
        std::memcpy(record + piece.offset, line, size);
        line += stride;
      }
    });
    from += piece.size;
  }
}

void FieldArrays::refuse(const std::string& name) const {
  throw py::attribute_error(device_ + ": found '" + prefix_ + name + "', allowed: " + joinNames(names()) +
                            didYouMean(name, names()));
}

py::object FieldArrays::get(const std::string& name) const {
  records_->moment.require();
  const std::string full = prefix_ + name;
  if (const FieldPlaces* field = table_->findField(full)) {
    const auto written = records_->written.find(field);
    if (written != records_->written.end()) {
      return written->second;
    }
    py::array copy = arrayFor(*field, size());
    gather(*records_->places, *field, copy.mutable_data());
    if (use_ == ArrayUse::kWrite) {
      records_->written.emplace(field, copy);
      return copy;
    }
    return withoutWriting(std::move(copy));
  }
  if (const ListPlaces* list = table_->findList(full)) {
    return py::cast(ListArrays(*records_, *list, device_));
  }
  if (table_->namesBehind(full + ".").empty()) {
    refuse(name);
  }
  return py::cast(FieldArrays(records_, *table_, device_, full + ".", use_));
}

void FieldArrays::set(const std::string& name, const py::object& value) const {
  records_->moment.require();
  const FieldPlaces* field = table_->findField(prefix_ + name);
  if (field == nullptr) {
    refuse(name);
  }
  const std::string full = device_ + "." + prefix_ + name;
  if (use_ != ArrayUse::kWrite) {
    throw py::type_error(full + " is not written here: commands are, in the step of a controller");
  }
  const py::array numbers = convert(value, *field, size(), full);
  scatter(numbers.data(), *field, *records_->places);
  const auto written = records_->written.find(field);
  if (written != records_->written.end() && isWhole(written->second, *field, size())) {
    std::memmove(written->second.mutable_data(), numbers.data(), static_cast<std::size_t>(numbers.nbytes()));
  }
}

void FieldArrays::writeBack() const {
  for (auto& [field, array] : records_->written) {
    if (isWhole(array, *field, size())) {
      scatter(array.data(), *field, *records_->places);
    }
    withoutWriting(array);
  }
  records_->written.clear();
}

std::string FieldArrays::describe() const {
  return "<" + device_ + " of " + std::to_string(size()) + ": " + joinNames(names()) + ">";
}

ListArrays::ListArrays(const Records& records, const ListPlaces& list, const std::string& device)
    : counts_(static_cast<py::ssize_t>(records.size())),
      elements_(elementArrays(records, list, device, counts_.mutable_data())) {
  const py::module_ numpy = py::module_::import("numpy");
  robot_ = withoutWriting(py::array(numpy.attr("repeat")(numpy.attr("arange")(records.size()), counts_)));
  counts_ = withoutWriting(std::move(counts_));
}

namespace {

/// The descriptor of each field of a device, without lists.
py::dict fieldsOf(const std::string& device) {
  const DeviceType* type = findDeviceType(device);
  if (type == nullptr) {
    std::vector<std::string> known;
    for (const DeviceType* other : deviceTypes()) {
      known.push_back(other->type);
    }
    throw py::key_error(unknownName("the device", device, known));
  }
  py::dict fields;
  for (const FieldPlaces& field : fieldTableOf(*type).fields) {
    const FieldDescription& description = type->fields.at(field.description);
    fields[py::str(field.name)] =
        py::dict(py::arg("shape") = py::tuple(py::cast(field.shape)), py::arg("dtype") = dtypeOf(field.type),
                 py::arg("unit") = description.unit, py::arg("meaning") = description.meaning,
                 py::arg("low") = description.range.minimum, py::arg("high") = description.range.maximum);
  }
  return fields;
}

}  // namespace

void bindFieldArrays(py::module_& module) {
  module.def(
      "fields_of", &fieldsOf, py::arg("device"),
      "The fields of a device of a type by name, each a dictionary: shape in one device, dtype, unit, meaning, and "
      "low and high, the bounds that its numbers keep.");
  py::class_<FieldArrays> fields_class(module, "FieldArrays", "Fields of one device of many robots, as arrays.");
  refuseUnmade<FieldArrays>();
  refuseCopies(fields_class, kOfAMoment);
  fields_class
      .def("__getattr__",
           [](const py::object& arrays, const std::string& name) {
             return partOf(arrays, arrays.cast<const FieldArrays&>(), name);
           })
      .def("__setattr__", &FieldArrays::set)
      .def("__dir__", &FieldArrays::names)
      .def("__len__", &FieldArrays::size)
      .def("__repr__", &FieldArrays::describe);
  py::class_<ListArrays> lists_class(module, "ListArrays",
                                     "A list of elements of many robots, as arrays over all elements.");
  refuseUnmade<ListArrays>();
  refuseCopies(lists_class, kOfAMoment);
  lists_class.def_property_readonly("counts", &ListArrays::counts, "How many elements each robot has.")
      .def_property_readonly("robot", &ListArrays::robot, "Whose each element is: a place among the robots.")
      .def("__getattr__",
           [](const py::object& list, const std::string& name) {
             return partOf(list, list.cast<const ListArrays&>().elements(), name);
           })
      .def("__dir__",
           [](const ListArrays& list) {
             std::vector<std::string> names = list.elements().names();
             names.insert(names.end(), {"counts", "robot"});
             return names;
           })
      .def("__len__", [](const ListArrays& list) { return list.elements().size(); })
      .def("__repr__", [](const ListArrays& list) { return list.elements().describe(); });
}

}  // namespace swarmanoid::bindings
