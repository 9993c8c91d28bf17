#include "growing_array.hpp"

#include <algorithm>
#include <cstring>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::trajectories {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{256} << 10U;
constexpr hsize_t kMostRows = 1024;

hsize_t product(const std::vector<hsize_t>& sizes, std::size_t first) {
  hsize_t product = 1;
  std::for_each(sizes.begin() + static_cast<std::ptrdiff_t>(std::min(first, sizes.size())), sizes.end(),
                [&](hsize_t size) { product *= size; });
  return product;
}

}  // namespace

Sizes::Sizes(hsize_t rows, const std::vector<hsize_t>& row_shape) : rank(row_shape.size() + 1) {
  SWARMANOID_EXPECTS(rank <= values.size());
  values[0] = rows;
  std::copy(row_shape.begin(), row_shape.end(), values.begin() + 1);
}

ElementType elementType(NumberType type) { return {typeOf(type), blank(type)}; }

GrowingArray::GrowingArray(hid_t file, const std::string& name, ElementType type, std::vector<hsize_t> row_shape,
                           bool widens)
    : type_(std::move(type)), row_shape_(std::move(row_shape)) {
  chooseChunk();
  const Sizes now(0, row_shape_);
  Sizes most(H5S_UNLIMITED, row_shape_);
  if (widens) {
    most.values[1] = H5S_UNLIMITED;
  }
  const Hdf5Id space(H5Screate_simple(now.dimensions(), now.data(), most.data()), H5Sclose, "making a space");
  const Hdf5Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "making properties");
  check(H5Pset_chunk(creation.get(), chunk_.dimensions(), chunk_.data()), "choosing chunks");
  check(H5Pset_fill_value(creation.get(), type_.id, type_.blank.data()), "choosing the blank");
  const Hdf5Id links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "making properties");
  check(H5Pset_create_intermediate_group(links.get(), 1), "making groups");
  // without a chunk cache: with one, the library would write a chunk after the number of rows that includes it
  const Hdf5Id access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, "making properties");
  check(H5Pset_chunk_cache(access.get(), 0, 0, H5D_CHUNK_CACHE_W0_DEFAULT), "leaving out the cache");
  dataset_ = Hdf5Id(H5Dcreate2(file, name.c_str(), type_.id, space.get(), links.get(), creation.get(), access.get()),
                    H5Dclose, ("making '" + name + "'").c_str());
  makeBuffer();
}

void GrowingArray::chooseChunk() {
  const std::size_t element = type_.blank.size();
  std::vector<hsize_t> part = row_shape_;
  if (!part.empty()) {
    const std::size_t behind = element * product(row_shape_, 1);
    part.front() = std::clamp<hsize_t>(row_shape_.front(), 1, std::max<hsize_t>(1, kChunkBytes / behind));
  }
  chunk_ = Sizes(std::clamp<hsize_t>(kChunkBytes / (element * product(part, 0)), 1, kMostRows), part);
}

void GrowingArray::makeBuffer() {
  const std::size_t element = type_.blank.size();
  row_bytes_ = element * product(row_shape_, 0);
  blank_row_.resize(row_bytes_);
  for (std::size_t i = 0; i < row_bytes_; i += element) {
    std::memcpy(blank_row_.data() + i, type_.blank.data(), element);
  }
  buffer_.resize(row_bytes_ * chunk_.values[0]);
}

std::byte* GrowingArray::next() {
  std::byte* row = buffer_.data() + count_ * row_bytes_;
  std::copy(blank_row_.begin(), blank_row_.end(), row);
  return row;
}

void GrowingArray::append() {
  if (++count_ == chunk_.values[0]) {
    write();
  }
}

void GrowingArray::widen(hsize_t size) {
  SWARMANOID_EXPECTS(size >= width());
  write();
  row_shape_.front() = size;
  makeBuffer();
  check(H5Dset_extent(dataset_.get(), Sizes(rows(), row_shape_).data()), "widening an array");
}

void GrowingArray::fillBack(hsize_t first_row, hsize_t index, const std::byte* value) {
  write();
  const std::size_t bytes = type_.blank.size() * product(row_shape_, 1);
  std::vector<std::byte> block(bytes * std::min(rows() - first_row, kMostRows));
  for (std::size_t i = 0; i < block.size(); i += bytes) {
    std::memcpy(block.data() + i, value, bytes);
  }
  Sizes start(0, row_shape_);
  Sizes count(0, row_shape_);
  std::fill(start.values.begin(), start.values.end(), 0);
  start.values[1] = index;
  count.values[1] = 1;
  for (hsize_t row = first_row; row < rows(); row += kMostRows) {
    start.values[0] = row;
    count.values[0] = std::min(rows() - row, kMostRows);
    writeBlock(start, count, block.data());
  }
}

void GrowingArray::write() {
  if (count_ > written_) {
    check(H5Dset_extent(dataset_.get(), Sizes(rows(), row_shape_).data()), "extending an array");
    if (row_bytes_ > 0) {
      Sizes start;
      start.rank = row_shape_.size() + 1;
      start.values[0] = first_ + written_;
      writeBlock(start, {count_ - written_, row_shape_}, buffer_.data() + written_ * row_bytes_);
    }
    written_ = count_;
  }
  if (count_ == chunk_.values[0]) {
    first_ += count_;
    count_ = written_ = 0;
  }
}

void GrowingArray::writeBlock(const Sizes& start, const Sizes& count, const std::byte* data) {
  const Hdf5Id memory(H5Screate_simple(count.dimensions(), count.data(), nullptr), H5Sclose, "making a space");
  const Hdf5Id place(H5Dget_space(dataset_.get()), H5Sclose, "reading a space");
  check(H5Sselect_hyperslab(place.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
        "choosing rows");
  check(H5Dwrite(dataset_.get(), type_.id, memory.get(), place.get(), H5P_DEFAULT, data), "writing rows");
}

}  // namespace swarmanoid::trajectories
