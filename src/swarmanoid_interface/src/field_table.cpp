#include "swarmanoid_interface/field_table.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

namespace swarmanoid {
namespace {

/// Removes the brackets from a name such as "joints[2].angle", and appends their indices to `indices`.
std::string withoutIndices(const std::string& name, std::vector<std::size_t>& indices) {
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '[') {
      const std::size_t end = name.find(']', i);
      indices.push_back(std::stoul(name.substr(i + 1, end - i - 1)));
      i = end;
    } else {
      plain += name[i];
    }
  }
  return plain;
}

/// Numbers are added in the order of their indices, so the last one determines the shape.
void add(FieldTable& table, const DeviceNumber& number) {
  std::vector<std::size_t> shape;
  const std::string name = withoutIndices(number.name, shape);
  std::for_each(shape.begin(), shape.end(), [](std::size_t& index) { ++index; });
  const auto known = std::find_if(table.fields.begin(), table.fields.end(),
                                  [&](const FieldPlaces& field) { return field.name == name; });
  FieldPlaces& field = known == table.fields.end() ? table.fields.emplace_back() : *known;
  field.name = name;
  field.type = *findNumberType(number.type);
  field.description = number.field;
  field.offsets.push_back(number.offset);
  field.shape = shape;
}

/// Merges adjacent numbers into pieces.
void joinPieces(FieldPlaces& field) {
  const std::size_t size = sizeOf(field.type);
  for (const std::size_t offset : field.offsets) {
    if (!field.pieces.empty() && field.pieces.back().offset + field.pieces.back().size == offset) {
      field.pieces.back().size += size;
    } else {
      field.pieces.push_back({offset, size});
    }
  }
}

FieldTable tableOf(const std::vector<DeviceNumber>& numbers) {
  FieldTable table;
  for (const DeviceNumber& number : numbers) {
    if (number.kind == DeviceNumber::Kind::kSpan) {
      table.lists.push_back({number.name, number.offset, number.span, tableOf(number.elements)});
    } else {
      add(table, number);
    }
  }
  std::for_each(table.fields.begin(), table.fields.end(), joinPieces);
  return table;
}

template <class Place>
const Place* findByName(const std::vector<Place>& places, const std::string& name) {
  const auto found = std::find_if(places.begin(), places.end(), [&](const Place& place) { return place.name == name; });
  return found == places.end() ? nullptr : &*found;
}

}  // namespace

const FieldPlaces* FieldTable::findField(const std::string& name) const { return findByName(fields, name); }

const ListPlaces* FieldTable::findList(const std::string& name) const { return findByName(lists, name); }

std::vector<std::string> FieldTable::namesBehind(const std::string& prefix) const {
  std::set<std::string> names;
  const auto add_name = [&](const std::string& name) {
    if (name.compare(0, prefix.size(), prefix) == 0) {
      names.insert(name.substr(prefix.size(), name.find('.', prefix.size()) - prefix.size()));
    }
  };
  std::for_each(fields.begin(), fields.end(), [&](const FieldPlaces& field) { add_name(field.name); });
  std::for_each(lists.begin(), lists.end(), [&](const ListPlaces& list) { add_name(list.name); });
  return {names.begin(), names.end()};
}

const FieldTable& fieldTableOf(const DeviceType& type) {
  static std::mutex mutex;
  static std::map<const DeviceType*, FieldTable> tables;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto known = tables.find(&type);
  return known != tables.end() ? known->second : tables.emplace(&type, tableOf(type.numbers)).first->second;
}

std::size_t sizeOf(NumberType type) {
  return withNumberType(type, [](auto zero) { return sizeof zero; });
}

}  // namespace swarmanoid
