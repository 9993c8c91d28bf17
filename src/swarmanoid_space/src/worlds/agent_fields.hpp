/// Fields of the devices of an agent, concatenated to one row of numbers in single precision.
///
/// Threads  any; it is not changed after construction.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/field_table.hpp"
#include "swarmanoid_space/state/bank.hpp"

namespace swarmanoid {

class AgentFields {
 public:
  /// @param names such as "footbot_proximity.value" @param option for messages @throws ConfigError
  AgentFields(const std::vector<std::string>& names, DeviceKind kind, const std::string& option);

  std::size_t size() const { return size_; }  ///< numbers of an agent

  /// Finds the addresses of an agent's devices, one for each field. @throws ConfigError if the robot lacks one @{
  void find(const Banks& banks, Row row, std::vector<const std::byte*>& devices) const { findIn(banks, row, devices); }
  void find(Banks& banks, Row row, std::vector<std::byte*>& devices) const { findIn(banks, row, devices); }
  /// @}

  /// Copies the numbers of an agent's devices to its row, and back. Numbers of whole-number fields are rounded, and cut
  /// to the range of their type; not a number becomes 0. @{
  void gather(const std::vector<const std::byte*>& devices, float* numbers) const;
  void scatter(const float* numbers, const std::vector<std::byte*>& devices) const;
  /// @}

 private:
  struct Part {
    const DeviceType* device;
    const FieldPlaces* field;
  };

  template <class SomeBanks, class Byte>
  void findIn(SomeBanks& banks, Row row, std::vector<Byte*>& devices) const {
    devices.clear();
    for (const Part& part : parts_) {
      auto* device = banks.find(part.device->type, row);
      if (device == nullptr) {
        refuse(*part.device);
      }
      devices.push_back(static_cast<Byte*>(device));
    }
  }
  [[noreturn]] void refuse(const DeviceType& device) const;

  std::string option_;
  std::vector<Part> parts_;
  std::size_t size_ = 0;
};

}  // namespace swarmanoid
