#include "bag_file.hpp"

#include <bzlib.h>
#include <roslz4/lz4s.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "bag_records.hpp"

namespace swarmanoid {

using bag_records::append;
using bag_records::Header;
using bag_records::Operation;

namespace {

constexpr std::size_t kChunkSize = std::size_t{768} << 10U;  // same as rosbag's [bytes]
constexpr std::uint32_t kVersion = 1;                        // of index and overview
constexpr std::string_view kFirstLine = "#ROSBAG V2.0\n";
constexpr std::size_t kFileHeaderSize = 4096;  // with padding, so that it can be rewritten in place

/// Size of an index record without its entries: a header with op, ver, conn and count, and the length of the data.
constexpr std::size_t kIndexHeaderSize = 4 + (4 + 4) + (4 + 8) + (4 + 9) + (4 + 10) + 4;
constexpr std::size_t kConnectionInIndex = 4 + (4 + 4) + (4 + 8) + 4 + 5;
constexpr std::size_t kCountInIndex = kConnectionInIndex + 4 + 4 + 6;
constexpr std::size_t kEntrySize = 12;

std::uint32_t numberAt(const std::vector<char>& bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

std::uint32_t lengthOf(const std::vector<char>& bytes) { return static_cast<std::uint32_t>(bytes.size()); }

}  // namespace

void BagFile::open(OutDescriptor file, Compression compression) {
  file_ = std::move(file);
  compression_ = compression;
}

std::optional<std::uint32_t> BagFile::findTopic(const std::string& name) const {
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? std::nullopt : std::optional<std::uint32_t>(found->second);
}

std::uint32_t BagFile::addTopic(const std::string& name, const Topic& topic) {
  const auto number = static_cast<std::uint32_t>(connections_.size());
  numbers_.emplace(name, number);
  connections_.emplace_back();
  Bytes& record = connections_.back().record;
  Header(record, Operation::kConnection).field("conn", number).field("topic", name);
  Header data(record);  // same layout as a header, including the length
  data.field("topic", name).field("type", topic.type).field("md5sum", topic.md5sum);
  data.field("message_definition", topic.definition);
  if (topic.is_latched) {
    data.field("latching", std::string_view("1")).field("callerid", std::string_view("/swarmanoid"));
  }
  return number;
}

std::uint8_t* BagFile::add(std::uint32_t topic, const ros::Time& stamp, std::uint32_t size) {
  if (messages_.size() >= kChunkSize) {
    writeChunk();
  }
  Connection& connection = connections_[topic];
  if (!connection.is_written) {
    connection.is_written = true;
    messages_.insert(messages_.end(), connection.record.begin(), connection.record.end());
  }
  connection.entries.push_back({stamp, lengthOf(messages_)});
  Header(messages_, Operation::kMessage).field("conn", topic).field("time", stamp);
  append(messages_, size);
  messages_.resize(messages_.size() + size);
  return reinterpret_cast<std::uint8_t*>(messages_.data() + messages_.size() - size);
}

void BagFile::flush() { writeChunk(); }

void BagFile::complete() {
  writeChunk();
  if (!is_complete_ && !is_lost_ && file_.isOpen()) {
    try {
      begin();
      writeEnd();
    } catch (...) {
      is_lost_ = true;
      endBeforeProblem();
      throw;
    }
  }
}

/// Prepares the file for more chunks.
void BagFile::begin() {
  if (!has_begun_) {
    file_.truncate(0);
    file_.writeAt(0, kFirstLine.data(), kFirstLine.size());
    end_ = kFirstLine.size() + 4 + 4 + kFileHeaderSize;
    has_begun_ = true;
    writeFileHeader(0);
  } else if (is_complete_) {
    file_.truncate(end_);
    writeFileHeader(0);
  }
  is_complete_ = false;
}

void BagFile::writeChunk() {
  if (messages_.empty()) {
    return;
  }
  const char* compression = compressed();
  const Bytes& data = packed_.empty() ? messages_ : packed_;
  output_.clear();
  Header(output_, Operation::kChunk)
      .field("compression", std::string_view(compression))
      .field("size", lengthOf(messages_));
  append(output_, lengthOf(data));
  output_.insert(output_.end(), data.begin(), data.end());
  Chunk chunk{end_, output_.size(), ros::TIME_MAX, ros::TIME_MIN};
  for (std::uint32_t number = 0; number < connections_.size(); ++number) {
    std::vector<Entry>& entries = connections_[number].entries;
    if (entries.empty()) {
      continue;
    }
    const auto count = static_cast<std::uint32_t>(entries.size());
    Header(output_, Operation::kIndex).field("ver", kVersion).field("conn", number).field("count", count);
    append(output_, static_cast<std::uint32_t>(count * kEntrySize));
    for (const Entry& entry : entries) {
      append(output_, entry.stamp);
      append(output_, entry.offset);
      chunk.first = std::min(chunk.first, entry.stamp);
      chunk.last = std::max(chunk.last, entry.stamp);
    }
    entries.clear();
  }
  messages_.clear();
  if (is_lost_ || !file_.isOpen()) {
    return;
  }
  try {
    begin();
    chunk.place = end_;
    chunk.index += end_;
    file_.writeAt(end_, output_.data(), output_.size());
    chunks_.push_back(chunk);
    end_ += output_.size();
  } catch (const std::exception& error) {
    is_lost_ = true;
    throw std::runtime_error(error.what() +
                             std::string(endBeforeProblem() ? "; what was written before is complete" : ""));
  }
}

/// Compresses the messages into packed_, which stays empty if they are not compressed. @return the format's name for
/// the compression
const char* BagFile::compressed() {
  packed_.clear();
  if (compression_ == Compression::kNone) {
    return "none";
  }
  constexpr std::size_t kOverhead = 4096;  // above the overhead of either format for incompressible data
  packed_.resize(messages_.size() + messages_.size() / 64 + kOverhead);
  unsigned int size = lengthOf(packed_);
  constexpr int kBlocks = 6;  // of 1 MiB
  constexpr int kBestBlocks = 9;
  constexpr int kWorkFactor = 30;
  const bool is_good = compression_ == Compression::kLz4
                           ? roslz4_buffToBuffCompress(messages_.data(), lengthOf(messages_), packed_.data(), &size,
                                                       kBlocks) == ROSLZ4_OK
                           : BZ2_bzBuffToBuffCompress(packed_.data(), &size, messages_.data(), lengthOf(messages_),
                                                      kBestBlocks, 0, kWorkFactor) == BZ_OK;
  packed_.resize(is_good ? size : 0);
  return !is_good ? "none" : compression_ == Compression::kLz4 ? "lz4" : "bz2";
}

void BagFile::writeFileHeader(std::uint64_t end) {
  Bytes header;
  Header(header, Operation::kFileHeader)
      .field("index_pos", end)
      .field("conn_count", static_cast<std::uint32_t>(end == 0 ? 0 : connections_.size()))
      .field("chunk_count", static_cast<std::uint32_t>(end == 0 ? 0 : chunks_.size()));
  const std::size_t padding = kFileHeaderSize - (header.size() - 4);
  append(header, static_cast<std::uint32_t>(padding));
  header.resize(header.size() + padding, ' ');
  file_.writeAt(kFirstLine.size(), header.data(), header.size());
}

void BagFile::writeEnd() {
  std::uint64_t place = end_;
  output_.clear();
  const auto write = [&] {
    file_.writeAt(place, output_.data(), output_.size());
    place += output_.size();
    output_.clear();
  };
  for (const Connection& connection : connections_) {
    output_.insert(output_.end(), connection.record.begin(), connection.record.end());
  }
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    appendOverview(i);
    if (output_.size() >= kChunkSize) {
      write();
    }
  }
  write();
  writeFileHeader(end_);
  is_complete_ = true;
}

/// Appends the overview of a chunk. The number of messages of each topic is read from the chunk's index.
void BagFile::appendOverview(std::size_t chunk) {
  const Chunk& about = chunks_[chunk];
  Bytes index((chunk + 1 < chunks_.size() ? chunks_[chunk + 1].place : end_) - about.index);
  file_.readAt(about.index, index.data(), index.size());
  Bytes counts;
  std::uint32_t topics = 0;
  for (std::size_t place = 0; place + kIndexHeaderSize <= index.size(); ++topics) {
    const std::uint32_t count = numberAt(index, place + kCountInIndex);
    append(counts, numberAt(index, place + kConnectionInIndex));
    append(counts, count);
    place += kIndexHeaderSize + count * kEntrySize;
  }
  Header(output_, Operation::kChunkInfo)
      .field("ver", kVersion)
      .field("chunk_pos", about.place)
      .field("start_time", about.first)
      .field("end_time", about.last)
      .field("count", topics);
  append(output_, lengthOf(counts));
  output_.insert(output_.end(), counts.begin(), counts.end());
}

/// Writes the end on a full disk. It needs space too, so the last chunks are removed until it fits.
/// @return false if no chunk is left
bool BagFile::endBeforeProblem() noexcept {
  while (!chunks_.empty()) {
    try {
      file_.truncate(end_);
      writeEnd();
      return true;
    } catch (...) {
      end_ = chunks_.back().place;
      chunks_.pop_back();
    }
  }
  return false;
}

}  // namespace swarmanoid
