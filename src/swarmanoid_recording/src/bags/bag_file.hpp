/// A file of the format "ROSBAG V2.0", written without a master.
///
/// The library's rosbag::Bag is not suitable: it buffers data until a chunk is full, throws out of its destructor when
/// the disk is full, and remembers every topic of every chunk, which is a gigabyte an hour for a thousand robots. This
/// class writes whole chunks, keeps a bag complete on a full disk, and remembers a few bytes per chunk. Players and
/// `rosbag reindex` are the library's.
///
/// Layout  a line, the file's header, then chunks of messages, each followed by an index of its topics; at the end all
///         topics, and an overview of all chunks, which the file's header points to. `rosbag reindex` completes a bag
///         without this end.
/// Errors  std::runtime_error that names writer, file and reason, once; later data is dropped.
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_recording/output/out_descriptor.hpp"

namespace swarmanoid {

class BagFile {
 public:
  enum class Compression { kNone, kLz4, kBz2 };

  struct Topic {
    std::string type;
    std::string md5sum;
    std::string definition;
    bool is_latched = false;  ///< players latch it
  };

  /// Sets the file; its old content is replaced with the first message.
  void open(OutDescriptor file, Compression compression);

  /// @return its number; nothing if it has not been added
  std::optional<std::uint32_t> findTopic(const std::string& name) const;
  std::uint32_t addTopic(const std::string& name, const Topic& topic);

  /// Adds a message; a complete bag is continued.
  /// @param size of the message [bytes] @return buffer for the message, valid until the next call
  std::uint8_t* add(std::uint32_t topic, const ros::Time& stamp, std::uint32_t size);

  /// Writes all added messages to the file.
  void flush();
  /// As flush, and writes the end of the bag.
  void complete();

 private:
  using Bytes = std::vector<char>;
  struct Entry {
    ros::Time stamp;
    std::uint32_t offset;  // in the chunk
  };
  struct Connection {
    Bytes record;
    bool is_written = false;
    std::vector<Entry> entries;  // of the open chunk
  };
  struct Chunk {
    std::uint64_t place;
    std::uint64_t index;  // position of the index of its topics
    ros::Time first;
    ros::Time last;
  };

  void begin();
  void writeChunk();
  void writeEnd();
  void writeFileHeader(std::uint64_t end);
  void appendOverview(std::size_t chunk);
  const char* compressed();
  bool endBeforeProblem() noexcept;

  OutDescriptor file_;
  Compression compression_ = Compression::kNone;
  std::map<std::string, std::uint32_t> numbers_;  // by topic
  std::vector<Connection> connections_;
  std::vector<Chunk> chunks_;
  std::uint64_t end_ = 0;  // end of the last chunk and its index
  Bytes messages_;         // of the open chunk
  Bytes packed_;           // messages_, compressed
  Bytes output_;
  bool has_begun_ = false;
  bool is_complete_ = false;
  bool is_lost_ = false;
};

}  // namespace swarmanoid
