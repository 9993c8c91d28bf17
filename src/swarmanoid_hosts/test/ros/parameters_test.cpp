#include "swarmanoid_hosts/ros/parameters.hpp"

#include <gtest/gtest.h>

namespace swarmanoid {
namespace {

TEST(Parameters, AreTextsWithPlaces) {
  XmlRpc::XmlRpcValue values;
  values["rate"] = 10;
  values["third"] = 1.0 / 3.0;
  values["is_on"] = true;
  values["name"] = std::string("fb_1");
  values["list"][0] = std::string("a");
  values["list"][1] = 2.5;
  values["inner"]["deep"] = 1;
  const Configuration read = configurationFrom(values, "configuration", "/node/configuration");
  EXPECT_EQ("configuration", read.name());
  EXPECT_EQ(10, read.integer("rate"));
  EXPECT_EQ(1.0 / 3.0, read.number("third")) << "to the last bit";
  EXPECT_TRUE(read.boolean("is_on"));
  EXPECT_EQ("fb_1", read.text("name"));
  EXPECT_EQ("a, 2.5", read.text("list"));
  EXPECT_EQ(1, read.find("inner")->integer("deep"));
  EXPECT_EQ("/node/configuration/inner/deep", read.find("inner")->find("deep")->location().toString());
}

TEST(Parameters, MustBeAStruct) {
  try {
    configurationFrom(XmlRpc::XmlRpcValue("text"), "configuration", "/node/configuration");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ("/node/configuration: found 'text', allowed: names with values", error.what());
  }
}

}  // namespace
}  // namespace swarmanoid
