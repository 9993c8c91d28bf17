/// Fields of the devices of an agent, concatenated to one row of numbers in single precision.
///
/// A field of a sensor's list is read by direction, or of the first elements (swarmanoid_interface/list_sectors.hpp),
/// with the attributes that neural controllers have: "footbot_camera.blobs.distance[sectors=8 near maximum=3
/// colors=yellow,green]", "ground.sensors.value[count=4]".
///
/// Threads  any; it is not changed after construction.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/field_table.hpp"
#include "swarmanoid_interface/list_sectors.hpp"
#include "swarmanoid_space/state/bank.hpp"

namespace swarmanoid {

class AgentFields {
 public:
  /// @param names such as "footbot_proximity.value" @param option for messages @throws ConfigError
  AgentFields(const std::vector<std::string>& names, DeviceKind kind, const std::string& option);

  std::size_t size() const { return size_; }  ///< numbers of an agent
  /// Bounds of each number by name, as the devices' descriptors give them; infinite without.
  std::vector<std::vector<Range>> bounds() const;

  /// Finds the addresses of an agent's devices, one for each field. @throws ConfigError if the robot lacks one @{
  void find(const Banks& banks, Row row, std::vector<const std::byte*>& devices) const { findIn(banks, row, devices); }
  void find(Banks& banks, Row row, std::vector<std::byte*>& devices) const { findIn(banks, row, devices); }
  /// @}

  /// Copies the numbers of an agent's devices to its row, and back. Numbers of whole-number fields are rounded, and cut
  /// to the range of their type; not a number becomes 0. @{
  void gather(const std::vector<const std::byte*>& devices, float* numbers) const;
  void scatter(const float* numbers, const std::vector<std::byte*>& devices) const;
  void scatter(const double* numbers, const std::vector<std::byte*>& devices) const;
  /// @}

 private:
  struct Part {
    const DeviceType* device;
    const FieldPlaces* field;  // null: of a list, in one of these
    std::optional<FirstElements> first;
    std::optional<ListSectors> sectors;
    std::size_t size() const { return field ? field->offsets.size() : first ? first->count() : sectors->count(); }
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
  /// @param rest behind the device: "blobs.distance[sectors=8]"
  Part partOf(const DeviceType& device, const std::string& rest) const;
  template <class Number>
  void write(const Number* numbers, const std::vector<std::byte*>& devices) const;

  std::string option_;
  std::vector<Part> parts_;
  std::size_t size_ = 0;
};

}  // namespace swarmanoid
