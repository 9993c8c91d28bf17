// Bags read by the library: all compressions, any number of topics and chunks, continuation after their end.
#include "../../src/bags/bag_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>

#include "../../src/bags/bag_writer.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

using Texts = std::vector<std::string>;

std_msgs::String message(const std::string& text) {
  std_msgs::String result;
  result.data = text;
  return result;
}

/// Returns an incompressible text.
std::string noise(std::size_t size, unsigned seed) {
  std::minstd_rand random(seed);
  std::string text(size, ' ');
  for (char& c : text) {
    c = static_cast<char>(random() >> 16U);
  }
  return text;
}

class BagFileTest : public testing::Test {
 protected:
  OutDescriptor file() const { return {open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666), path_, "test"}; }

  Texts read(const std::string& topic = "") const {
    const rosbag::Bag bag(path_, rosbag::bagmode::Read);
    rosbag::View view;
    if (topic.empty()) {
      view.addQuery(bag);
    } else {
      view.addQuery(bag, rosbag::TopicQuery(topic));
    }
    Texts texts;
    for (const rosbag::MessageInstance& instance : view) {
      texts.push_back(instance.instantiate<std_msgs::String>()->data);
    }
    return texts;
  }

  const TemporaryFolder owner_{"bag_file_test"};
  const std::string path_ = owner_.path() / "run.bag";
};

TEST_F(BagFileTest, IsReadAsItWasWritten) {
  for (const auto compression : {BagFile::Compression::kNone, BagFile::Compression::kLz4, BagFile::Compression::kBz2}) {
    for (const bool is_noise : {false, true}) {
      BagWriter bag;
      bag.open(file(), compression);
      Texts expected;
      for (unsigned i = 0; i < 40; ++i) {  // some megabytes: several chunks
        expected.push_back(is_noise ? noise(100000 + i, i) : std::string(100000 + i, static_cast<char>('a' + i % 26)));
        bag.write("/text", ros::Time(1, i), message(expected.back()));
      }
      bag.complete();
      EXPECT_EQ(read(), expected) << static_cast<int>(compression) << is_noise;
      EXPECT_EQ(is_noise || compression == BagFile::Compression::kNone, std::filesystem::file_size(path_) > 3500000U)
          << static_cast<int>(compression) << is_noise << ' ' << std::filesystem::file_size(path_);
    }
  }
}

TEST_F(BagFileTest, KnowsItsTopicsAndTimes) {
  BagWriter bag;
  bag.open(file(), BagFile::Compression::kLz4);
  bag.writeLatched("/latched", ros::Time(3, 5), message("a"));
  bag.write("/other", ros::Time(2, 7), message("b"));
  bag.flush();
  bag.write("/other", ros::Time(9, 1), message("c"));
  bag.complete();
  EXPECT_EQ(read(), (Texts{"b", "a", "c"}));
  EXPECT_EQ(read("/other"), (Texts{"b", "c"}));
  const rosbag::Bag opened(path_, rosbag::bagmode::Read);
  rosbag::View view(opened);
  EXPECT_EQ(view.getBeginTime(), ros::Time(2, 7));
  EXPECT_EQ(view.getEndTime(), ros::Time(9, 1));
  for (const rosbag::ConnectionInfo* info : view.getConnections()) {
    EXPECT_EQ(info->datatype, "std_msgs/String");
    EXPECT_EQ(info->md5sum, ros::message_traits::md5sum<std_msgs::String>());
    EXPECT_EQ(info->msg_def, ros::message_traits::definition<std_msgs::String>());
    EXPECT_EQ(info->header->count("latching"), info->topic == "/latched" ? 1U : 0U);
  }
}

TEST_F(BagFileTest, GoesOnAfterItsEnd) {
  BagWriter bag;
  bag.open(file(), BagFile::Compression::kLz4);
  Texts expected;
  for (unsigned part = 0; part < 3; ++part) {
    for (unsigned i = 0; i < 5; ++i) {
      expected.push_back(std::to_string(part) + std::to_string(i));
      bag.write("/topic_" + std::to_string(i + part), ros::Time(part + 1, i), message(expected.back()));
    }
    bag.complete();
    bag.flush();
    EXPECT_EQ(read(), expected);
  }
}

TEST_F(BagFileTest, ReplacesWhatWasThere) {
  std::ofstream(path_) << std::string(1000000, 'x');
  BagWriter bag;
  bag.open(file(), BagFile::Compression::kNone);
  EXPECT_EQ(std::filesystem::file_size(path_), 1000000U) << "not before it is written";
  bag.write("/text", ros::Time(1, 0), message("a"));
  bag.complete();
  EXPECT_EQ(read(), Texts{"a"});
  EXPECT_LT(std::filesystem::file_size(path_), 10000U);
}

TEST_F(BagFileTest, WithoutMessagesIsABagToo) {
  BagWriter bag;
  bag.open(file(), BagFile::Compression::kLz4);
  bag.complete();
  EXPECT_EQ(read(), Texts{});
}

TEST_F(BagFileTest, ThousandsOfTopicsInThousandsOfChunks) {
  BagWriter bag;
  bag.open(file(), BagFile::Compression::kNone);
  const auto peak = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // [KiB]
  };
  constexpr unsigned kTopics = 2000;
  constexpr unsigned kChunks = 300;
  long after_first = 0;
  for (unsigned chunk = 0; chunk < kChunks; ++chunk) {
    for (unsigned topic = 0; topic < kTopics; ++topic) {
      bag.write("/robot_" + std::to_string(topic), ros::Time(chunk + 1, topic), message("x"));
    }
    bag.flush();
    after_first = chunk == 10 ? peak() : after_first;
  }
  EXPECT_LT(peak() - after_first, 8000) << "rosbag::Bag takes some 100 KiB a chunk";
  bag.complete();
  EXPECT_EQ(read("/robot_1999").size(), kChunks);
}

/// Simulates a full disk by a limit on file sizes, which needs no privileges.
class FullDiskTest : public BagFileTest {
 protected:
  void SetUp() override {
    BagFileTest::SetUp();
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
  }
  void TearDown() override {
    setrlimit(RLIMIT_FSIZE, &before_);
    BagFileTest::TearDown();
  }
  void limit(rlim_t size) {
    rlimit now = before_;
    now.rlim_cur = size;
    setrlimit(RLIMIT_FSIZE, &now);
  }

  rlimit before_{};
};

TEST_F(FullDiskTest, KeepsTheBagComplete) {
  for (const rlim_t size : {20000U, 100000U, 101000U, 333333U}) {
    std::filesystem::remove(path_);
    BagWriter bag;
    bag.open(file(), BagFile::Compression::kNone);
    limit(size);
    Texts written;
    try {
      for (unsigned i = 0; i < 1000; ++i) {
        bag.write("/text", ros::Time(1, i), message(noise(1000, i)));
        bag.flush();
        written.push_back(noise(1000, i));
      }
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(),
                "test: writing " + path_ + " failed: File too large; what was written before is complete");
    }
    bag.write("/text", ros::Time(2, 0), message("dropped"));
    EXPECT_NO_THROW(bag.complete()) << "it is reported once";
    const Texts kept = read();
    ASSERT_LE(kept.size(), written.size());
    EXPECT_GE(10 * kept.size() + 20, 9 * written.size()) << "the end takes little room";
    EXPECT_TRUE(std::equal(kept.begin(), kept.end(), written.begin()));
  }
}

TEST_F(FullDiskTest, WhereNotEvenTheHeaderFits) {
  BagWriter bag;
  bag.open(file(), BagFile::Compression::kLz4);
  limit(100);
  bag.write("/text", ros::Time(1, 0), message("a"));
  try {
    bag.flush();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "test: writing " + path_ + " failed: File too large");
  }
}

}  // namespace
}  // namespace swarmanoid
