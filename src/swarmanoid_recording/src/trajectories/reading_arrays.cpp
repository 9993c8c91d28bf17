#include "reading_arrays.hpp"

#include <algorithm>
#include <cstring>

namespace swarmanoid::trajectories {
namespace {

/// Returns the path with groups instead of points.
std::string pathOf(std::string name) {
  std::replace(name.begin(), name.end(), '.', '/');
  return name;
}

std::vector<hsize_t> shapeOf(const FieldPlaces& field) { return {field.shape.begin(), field.shape.end()}; }

std::size_t bytesOf(const FieldPlaces& field) { return sizeOf(field.type) * field.offsets.size(); }

void copyRecord(const FieldPlaces& field, const std::byte* record, std::byte* target) {
  for (const FieldPlaces::Piece& piece : field.pieces) {
    std::memcpy(target, record + piece.offset, piece.size);
    target += piece.size;
  }
}

/// Returns "blobs[].bearing" without the brackets and their contents.
std::string withoutBrackets(const std::string& name) {
  std::string plain;
  bool is_inside = false;
  for (const char character : name) {
    is_inside = character == '[' || (is_inside && character != ']');
    if (!is_inside && character != ']') {
      plain += character;
    }
  }
  return plain;
}

void describe(const GrowingArray& array, const DeviceType& type, const std::string& name) {
  for (const FieldDescription& field : type.fields) {
    if (withoutBrackets(field.name) == name) {
      setAttribute(array.id(), "unit", field.unit);
      setAttribute(array.id(), "meaning", field.meaning);
    }
  }
}

}  // namespace

ReadingArrays::ReadingArrays(hid_t file, const DeviceType& type, const Space& space, const std::vector<Row>& columns)
    : type_(type), robots_(file, "readings/" + type.type + "/robots", elementType(NumberType::kI4), {}) {
  find(space, columns);
  const hsize_t robots = devices_.size();
  const std::string folder = "readings/" + type.type + "/";
  const FieldTable& table = fieldTableOf(type);
  for (const FieldPlaces& places : table.fields) {
    std::vector<hsize_t> shape = shapeOf(places);
    shape.insert(shape.begin(), robots);
    fields_.push_back(
        {&places, bytesOf(places), {file, folder + pathOf(places.name), elementType(places.type), shape, true}});
    describe(fields_.back().array, type, places.name);
  }
  for (const ListPlaces& places : table.lists) {
    const std::string list = folder + pathOf(places.name) + "/";
    lists_.push_back({&places, {file, list + "counts", elementType(NumberType::kU4), {robots}, true}, {}});
    setAttribute(lists_.back().counts.id(), "is_count", true);
    for (const FieldPlaces& field : places.elements.fields) {
      lists_.back().fields.push_back(
          {&field, bytesOf(field), {file, list + pathOf(field.name), elementType(field.type), shapeOf(field)}});
      describe(lists_.back().fields.back().array, type, places.name + "." + field.name);
    }
  }
}

void ReadingArrays::find(const Space& space, const std::vector<Row>& columns) {
  constexpr int kNone = -1;
  place_of_column_.resize(columns.size(), kNone);
  std::fill(devices_.begin(), devices_.end(), nullptr);
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const void* device = columns[column] == kNoRow ? nullptr : space.readings.find(type_.type, columns[column]);
    if (device == nullptr) {
      continue;
    }
    int& place = place_of_column_[column];
    if (place == kNone) {
      place = static_cast<int>(devices_.size());
      devices_.push_back(nullptr);
      const auto number = static_cast<std::int32_t>(column);
      std::memcpy(robots_.next(), &number, sizeof number);
      robots_.append();
    }
    devices_[static_cast<std::size_t>(place)] = static_cast<const std::byte*>(device);
  }
}

void ReadingArrays::append(const Space& space, const std::vector<Row>& columns) {
  const std::size_t before = devices_.size();
  find(space, columns);
  if (devices_.size() > before) {
    std::for_each(fields_.begin(), fields_.end(), [&](Field& field) { field.array.widen(devices_.size()); });
    std::for_each(lists_.begin(), lists_.end(), [&](List& list) { list.counts.widen(devices_.size()); });
  }
  std::for_each(fields_.begin(), fields_.end(), [&](Field& field) { appendField(field); });
  std::for_each(lists_.begin(), lists_.end(), [&](List& list) { appendList(list); });
}

void ReadingArrays::appendField(Field& field) {
  std::byte* target = field.array.next();
  for (const std::byte* device : devices_) {
    if (device != nullptr) {
      copyRecord(*field.places, device, target);
    }
    target += field.bytes;
  }
  field.array.append();
}

void ReadingArrays::appendList(List& list) {
  std::byte* counts = list.counts.next();
  for (const std::byte* device : devices_) {
    std::uint32_t count = 0;
    if (device != nullptr) {
      const std::size_t size = list.places->access.element_size;
      const Span<const std::byte> bytes = list.places->access.bytes(device + list.places->offset);
      count = static_cast<std::uint32_t>(bytes.size() / size);
      for (std::size_t element = 0; element < bytes.size(); element += size) {
        for (Field& field : list.fields) {
          copyRecord(*field.places, bytes.data() + element, field.array.next());
          field.array.append();
        }
      }
    }
    std::memcpy(counts, &count, sizeof count);
    counts += sizeof count;
  }
  list.counts.append();
}

void ReadingArrays::write() {
  robots_.write();
  std::for_each(fields_.begin(), fields_.end(), [](Field& field) { field.array.write(); });
  for (List& list : lists_) {
    list.counts.write();
    std::for_each(list.fields.begin(), list.fields.end(), [](Field& field) { field.array.write(); });
  }
}

}  // namespace swarmanoid::trajectories
