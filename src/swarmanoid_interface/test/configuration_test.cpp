// Values from experiment files: accepted values, and the exact messages for refused ones.
#include "swarmanoid_interface/configuration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "swarmanoid_interface/readable_number.hpp"

namespace swarmanoid {
namespace {

const SourceLocation kPlace{"world.xml", 12};

/// <footbot_camera> of line 12, with one value in line 13.
Configuration with(const std::string& name, const std::string& text) {
  Configuration configuration("footbot_camera", "", kPlace);
  configuration.add(Configuration(name, text, {"world.xml", 13}));
  return configuration;
}

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

std::string numberMessage(const std::string& text, Range range = {}) {
  return messageOf([&] { with("range", text).number("range", range); });
}

TEST(ConfigurationTest, ReadsNumbersAsTheyAreWritten) {
  for (const auto& [text, value] : {std::pair("0.5", 0.5), std::pair(" 2 ", 2.0), std::pair("-1e-3", -1e-3),
                                    std::pair("+7", 7.0), std::pair("\n\t1.25\r\n", 1.25), std::pair(".5", 0.5)}) {
    EXPECT_EQ(with("range", text).number("range"), value) << text;
  }
}

TEST(ConfigurationTest, RefusesWhatIsNoNumberWithFileAndLine) {
  for (const char* text : {"", "0,5", "1 2", "0.5m", "nan", "inf", "-inf", "1e999", "0x10", "--1", "+-1", "true"}) {
    EXPECT_EQ(numberMessage(text), "world.xml:13: range: found '" + std::string(text) + "', allowed: a number");
  }
}

TEST(ConfigurationTest, SaysTheRangeThatANumberLeaves) {
  EXPECT_EQ(numberMessage("1.5", {0.0, 1.0}), "world.xml:13: range: found '1.5', allowed: a number from 0 to 1");
  EXPECT_EQ(numberMessage("-0.1", {0.0, kInfinity}), "world.xml:13: range: found '-0.1', allowed: a number at least 0");
  EXPECT_EQ(numberMessage("3", {-kInfinity, 2.5}), "world.xml:13: range: found '3', allowed: a number at most 2.5");
  EXPECT_EQ(numberMessage("0", {0.0, 1.0}), "");
  EXPECT_EQ(numberMessage("1", {0.0, 1.0}), "");
  EXPECT_EQ(numberMessage("-0.09", {-1.0, 1.0, 0.1}),
            "world.xml:13: range: found '-0.09', allowed: a number from -1 to 1 (0, or at least 0.1)");
  for (const char* const text : {"-0.1", "0", "-0", "0.1"}) {
    EXPECT_EQ(numberMessage(text, {-1.0, 1.0, 0.1}), "") << text;
  }
}

TEST(ConfigurationTest, MessagesHaveNumbersThatPeopleRead) {
  EXPECT_EQ(readableNumber(2.3456789012345678), "2.346");
  EXPECT_EQ(readableNumber(-0.1 - 0.2), "-0.3");
  EXPECT_EQ(readableNumber(-0.0004), "0");
  EXPECT_EQ(readableNumber(12.0), "12");
  EXPECT_EQ(readableNumber(1e300), "1e+300");
  EXPECT_EQ(readableNumber(std::nan("")), "nan");
  EXPECT_EQ(readableNumber(-kInfinity), "-inf");
}

TEST(ConfigurationTest, RefusesWhatIsNoWholeNumber) {
  for (const char* text : {"1.0", "1e3", "9223372036854775808", "", "seven", "1,2"}) {
    EXPECT_EQ(messageOf([&] { with("max_blobs", text).integer("max_blobs"); }),
              "world.xml:13: max_blobs: found '" + std::string(text) + "', allowed: a whole number");
  }
  EXPECT_EQ(with("max_blobs", "-9223372036854775808").integer("max_blobs"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(messageOf([] {
              with("max_blobs", "0").integer("max_blobs", {1.0, 100.0});
            }),
            "world.xml:13: max_blobs: found '0', allowed: a whole number from 1 to 100");
}

TEST(ConfigurationTest, RefusesWhatIsNeitherTrueNorFalse) {
  for (const char* text : {"True", "1", "yes", ">true", ""}) {
    EXPECT_EQ(messageOf([&] { with("sees_floor", text).boolean("sees_floor"); }),
              "world.xml:13: sees_floor: found '" + std::string(text) + "', allowed: true, false");
  }
  EXPECT_TRUE(with("sees_floor", " true ").boolean("sees_floor"));
}

TEST(ConfigurationTest, ReadsVectorsOfTheRightLengthOnly) {
  EXPECT_EQ(with("position", "1, -2.5,3e1").vector3("position"), Eigen::Vector3d(1.0, -2.5, 30.0));
  EXPECT_EQ(with("size", "1024, 768").vector2("size"), Eigen::Vector2d(1024.0, 768.0));
  for (const char* text : {"1,2", "1,2,3,4", "1,2,3,", ",1,2", "1 2 3", "1,,3", "1,2,nan", ""}) {
    EXPECT_EQ(messageOf([&] { with("position", text).vector3("position"); }),
              "world.xml:13: position: found '" + std::string(text) + "', allowed: 3 numbers separated by commas");
  }
}

TEST(ConfigurationTest, TurnsDegreesIntoRadiansButNotTheFallback) {
  EXPECT_DOUBLE_EQ(with("aperture", "45").angle("aperture", 0.0), M_PI / 4.0);
  EXPECT_EQ(Configuration().angle("aperture", 0.3), 0.3);
  EXPECT_EQ(messageOf([] {
              with("aperture", "90").angle("aperture", 0.0, {1.0, 85.0});
            }),
            "world.xml:13: aperture: found '90', allowed: a number from 1 to 85");
}

TEST(ConfigurationTest, NamesTheColourThatWasMeant) {
  EXPECT_EQ(with("color", "10, 20,30").color("color"), (Color{10, 20, 30}));
  const std::string all = "black, white, red, green, blue, yellow, magenta, cyan, orange, gray";
  EXPECT_EQ(messageOf([] { with("color", "yelow").color("color"); }),
            "world.xml:13: color: found 'yelow', allowed: " + all +
                ", or three numbers from 0 to 255; did you mean 'yellow'?");
  EXPECT_EQ(messageOf([] { with("color", "0,0,256").color("color"); }),
            "world.xml:13: color: found '0,0,256', allowed: " + all + ", or three numbers from 0 to 255");
}

TEST(ConfigurationTest, SaysWhatIsMissingAndWhere) {
  EXPECT_EQ(messageOf([] { with("range", "1").number("noise"); }),
            "world.xml:12: <footbot_camera> has no 'noise', which it needs");
  EXPECT_EQ(with("range", "1").number("noise", 0.25), 0.25);
}

TEST(ConfigurationTest, AMalformedValueIsNeverReplacedByTheFallback) {
  EXPECT_EQ(messageOf([] { with("range", "far").number("range", 2.0); }),
            "world.xml:13: range: found 'far', allowed: a number");
}

TEST(ConfigurationTest, RefusesWhatNobodyAskedForAndNamesTheNearest) {
  const Configuration configuration = with("nois", "1");
  EXPECT_EQ(messageOf([&] {
              configuration.refuseUnread({"range", "noise"});
            }),
            "world.xml:13: 'nois' is not known in <footbot_camera>; allowed: range, noise; did you mean 'noise'?");
  EXPECT_EQ(messageOf([&] { configuration.refuseUnread(); }), "world.xml:13: 'nois' is not known in <footbot_camera>");
  configuration.number("nois");
  EXPECT_NO_THROW(configuration.refuseUnread());
}

TEST(ConfigurationTest, AValueThatStandsTwiceIsRefusedAsThat) {
  Configuration configuration = with("speed", "0.1");
  configuration.add(Configuration("speed", "0.2", {"world.xml", 14}));
  EXPECT_EQ(configuration.number("speed"), 0.1);
  EXPECT_EQ(messageOf([&] { configuration.refuseUnread({"speed"}); }),
            "world.xml:14: 'speed' stands in <footbot_camera> twice");
}

TEST(SourceLocationTest, SaysAsMuchAsIsKnown) {
  EXPECT_EQ((SourceLocation{"a.xml", 3}).toString(), "a.xml:3");
  EXPECT_EQ((SourceLocation{"a.xml", 0}).toString(), "a.xml");
  EXPECT_EQ(SourceLocation{}.toString(), "");
}

TEST(ConfigErrorTest, SaysTheValueAloneIfItStandsInNoFile) {
  EXPECT_STREQ(ConfigError({"a.xml", 3}, "found x").what(), "a.xml:3: found x");
  EXPECT_STREQ(ConfigError({}, "found x").what(), "found x");
}

TEST(ParseNumbersTest, EachIsInTheRange) {
  EXPECT_EQ(parseNumbers("1, 2,3", 3, "size", {}, {1.0, 3.0}), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(messageOf([] {
              parseNumbers("1, 2, 1e40", 3, "size", {"a.xml", 3}, {1.0, 3.0});
            }),
            "a.xml:3: size: found '1, 2, 1e40', allowed: 3 numbers separated by commas, each from 1 to 3");
}

TEST(NearestNameTest, FindsWhatWasMeantAndGuessesNothingFarOff) {
  const std::vector<std::string> names{"footbot_wheels", "footbot_leds", "footbot_camera", "z"};
  EXPECT_EQ(nearestName("footbot_wheel", names), "footbot_wheels");
  EXPECT_EQ(nearestName("fotbot_camera", names), "footbot_camera");
  EXPECT_EQ(nearestName("footbot_led", names), "footbot_leds");
  EXPECT_EQ(nearestName("laser", names), std::nullopt);
  EXPECT_EQ(nearestName("x", names), std::nullopt);
  EXPECT_EQ(nearestName("", names), std::nullopt);
  EXPECT_EQ(nearestName("footbot_leds", {}), std::nullopt);
}

}  // namespace
}  // namespace swarmanoid
