// Fields that a name in an <error> selects, and refused names.
#include "swarmanoid_space/error_models/field_selection.hpp"

#include <gtest/gtest.h>

#include "error_probe.hpp"

namespace swarmanoid::test {
namespace {

std::string refusalOf(const ErrorModelDescription& error, const DeviceType& device = probeType()) {
  try {
    ErrorChain(device).add(error);
  } catch (const ConfigError& problem) {
    return problem.what();
  }
  return "";
}

TEST(FieldSelectionTest, RefusesWhatDoesNotSuit) {
  EXPECT_EQ(refusalOf(error("gausian", "", {})),
            "file.xml:3: found the error kind 'gausian', allowed: bias, dead, drop_out, factor, factor_spread, "
            "gaussian, latency, offset_spread, quantisation, random_walk, saturation, stuck, uniform; did you mean "
            "'gaussian'?");
  EXPECT_EQ(refusalOf(error("bias", "valeu", {{"offset", "1"}})),
            "file.xml:4: found the field 'valeu', allowed: free, value, heading, level, echoes[].distance, "
            "echoes[].strength; did you mean 'value'? (of probe_of_a_test)");
  EXPECT_EQ(refusalOf(error("bias", "on", {{"offset", "1"}})),
            "file.xml:4: found the field 'on' (a truth value) for the error kind 'bias', allowed: free, value, "
            "heading, level, echoes[].distance, echoes[].strength");
  EXPECT_EQ(refusalOf(error("bias", "mode", {{"offset", "1"}})).substr(0, 55),
            "file.xml:4: found the field 'mode' (one of several mode");
  EXPECT_EQ(refusalOf(error("stuck", "echoes[].distance", {})),
            "file.xml:4: found the field 'echoes[].distance' (elements that are others in the next tick) for the error "
            "kind 'stuck', allowed: free, value, heading, level, on, mode, echoes");
  EXPECT_EQ(refusalOf(error("bias", "", {{"offset", "1"}}), *findDeviceType(ProbeSwitch::kType)),
            "file.xml:4: found the error kind 'bias' for sensor 'probe_switch_of_a_test', which has no numbers, "
            "allowed: a kind for any field");
  EXPECT_EQ(refusalOf(error("saturation", "free", {{"minimum", "2"}, {"maximum", "1"}})),
            "file.xml:5: maximum: found 1, allowed: at least the minimum, 2");
  EXPECT_NE(refusalOf(error("bias", "value[9]", {{"offset", "1"}})), "");
  for (const char* field : {"value", "value[]", "value[3]", "", "echoes", "echoes[].distance"}) {
    EXPECT_EQ(refusalOf(error("bias", field, {{"offset", "1"}})), "") << field;
  }
}

TEST(FieldSelectionTest, OneElementOfAnArrayCanBeChosen) {
  ErrorChain chain(probeType());
  chain.add(error("bias", "value[2]", {{"offset", "0.25"}}));
  ErrorState state = chain.makeState(1, "robot", 0);
  Probe probe;
  chain.apply(&probe, state, 0);
  EXPECT_EQ(probe.value, (std::array<float, 4>{0.5F, 0.5F, 0.75F, 0.5F}));
}

}  // namespace
}  // namespace swarmanoid::test
