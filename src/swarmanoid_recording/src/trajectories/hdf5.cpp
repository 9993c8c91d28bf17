#include "hdf5.hpp"

#include <cstring>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace swarmanoid::trajectories {
namespace {

hid_t makeTruthValue() {
  const hid_t type = H5Tenum_create(H5T_NATIVE_INT8);
  for (const auto& [name, value] : {std::pair{"FALSE", std::int8_t{0}}, std::pair{"TRUE", std::int8_t{1}}}) {
    check(H5Tenum_insert(type, name, &value), "making the type of truth values");
  }
  return type;
}

hid_t makeText() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  check(H5Tset_size(type, H5T_VARIABLE), "making the type of texts");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "making the type of texts");
  return type;
}

hid_t textType() {
  static const hid_t kType = makeText();
  return kType;
}

void write(hid_t object, const std::string& name, hid_t type, const Hdf5Id& space, const void* data) {
  if (H5Aexists(object, name.c_str()) > 0) {
    check(H5Adelete(object, name.c_str()), "replacing an attribute");
  }
  const Hdf5Id attribute(H5Acreate2(object, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         ("making the attribute '" + name + "'").c_str());
  check(H5Awrite(attribute.get(), type, data), "writing an attribute");
}

Hdf5Id oneValue() { return {H5Screate(H5S_SCALAR), H5Sclose, "making a space"}; }

}  // namespace

Hdf5Id::Hdf5Id(hid_t id, Close close, const char* doing) : id_(id), close_(close) {
  if (id_ < 0) {
    throw std::runtime_error(std::string("HDF5: ") + doing + " failed");
  }
}

Hdf5Id& Hdf5Id::operator=(Hdf5Id&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(close_, other.close_);
  return *this;
}

void Hdf5Id::reset() {
  if (id_ >= 0) {
    close_(std::exchange(id_, -1));
  }
}

void check(herr_t result, const char* doing) {
  if (result < 0) {
    throw std::runtime_error(std::string("HDF5: ") + doing + " failed");
  }
}

void silenceHdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

hid_t typeOf(NumberType type) {
  static const hid_t kTruthValue = makeTruthValue();
  switch (type) {
    case NumberType::kF4:
      return H5T_NATIVE_FLOAT;
    case NumberType::kB1:
      return kTruthValue;
    case NumberType::kU1:
      return H5T_NATIVE_UINT8;
    case NumberType::kU2:
      return H5T_NATIVE_UINT16;
    case NumberType::kU4:
      return H5T_NATIVE_UINT32;
    case NumberType::kU8:
      return H5T_NATIVE_UINT64;
    case NumberType::kI1:
      return H5T_NATIVE_INT8;
    case NumberType::kI2:
      return H5T_NATIVE_INT16;
    case NumberType::kI4:
      return H5T_NATIVE_INT32;
    case NumberType::kI8:
      return H5T_NATIVE_INT64;
    case NumberType::kF8:
      break;
  }
  return H5T_NATIVE_DOUBLE;
}

std::vector<std::byte> blank(NumberType type) {
  return withNumberType(type, [](auto value) {
    using Number = decltype(value);
    if constexpr (std::is_floating_point_v<Number>) {
      value = std::numeric_limits<Number>::quiet_NaN();
    }
    std::vector<std::byte> bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
  });
}

void setAttribute(hid_t object, const std::string& name, const std::string& value) {
  const char* text = value.c_str();
  write(object, name, textType(), oneValue(), &text);
}

void setAttribute(hid_t object, const std::string& name, const std::vector<std::string>& values) {
  std::vector<const char*> texts;
  texts.reserve(values.size() + 1);  // the library requires an address even for zero texts
  for (const std::string& value : values) {
    texts.push_back(value.c_str());
  }
  const hsize_t count = texts.size();
  const Hdf5Id space(H5Screate_simple(1, &count, nullptr), H5Sclose, "making a space");
  write(object, name, textType(), space, texts.data());
}

void setAttribute(hid_t object, const std::string& name, double value) {
  write(object, name, H5T_NATIVE_DOUBLE, oneValue(), &value);
}

void setAttribute(hid_t object, const std::string& name, std::uint64_t value) {
  write(object, name, H5T_NATIVE_UINT64, oneValue(), &value);
}

void setAttribute(hid_t object, const std::string& name, bool value) {
  write(object, name, typeOf(NumberType::kB1), oneValue(), &value);
}

}  // namespace swarmanoid::trajectories
