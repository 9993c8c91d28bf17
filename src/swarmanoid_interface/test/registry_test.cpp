// The registry of plugins: lookup by name, and conflicts between plugins of the same name.
#include "swarmanoid_interface/registry.hpp"

#include <gtest/gtest.h>

namespace swarmanoid {
namespace {

using Names = std::vector<std::string>;

struct Plugin {
  int number = 0;
};

void add(Registry& registry, PluginKind kind, const std::string& label, const std::string& implementation, int number,
         const Names& label_aliases = {}, const Names& implementation_aliases = {}) {
  PluginDescription description;
  description.label = label;
  description.implementation = implementation;
  description.label_aliases = label_aliases;
  description.implementation_aliases = implementation_aliases;
  registry.add(kind, description, [number] { return std::make_shared<Plugin>(Plugin{number}); });
}

/// Returns the number of the plugin that is found; -1 if there is none.
int found(const Registry& registry, PluginKind kind, const std::string& label, const std::string& implementation = "") {
  const Registry::Entry* entry = registry.find(kind, label, implementation);
  return entry == nullptr ? -1 : makePlugin<Plugin>(*entry)->number;
}

TEST(RegistryTest, FindsByLabelImplementationAndAlias) {
  Registry registry;
  add(registry, PluginKind::kSensor, "footbot_camera", "color_blobs", 1, {"pie_camera"}, {"generic_pie_camera"});
  add(registry, PluginKind::kSensor, "footbot_camera", "ideal", 2);
  for (const char* label : {"footbot_camera", "pie_camera"}) {
    EXPECT_EQ(found(registry, PluginKind::kSensor, label), 1);  // none is declared as the default: the first by name
    EXPECT_EQ(found(registry, PluginKind::kSensor, label, "generic_pie_camera"), 1);
  }
  EXPECT_EQ(found(registry, PluginKind::kSensor, "footbot_camera", "ideal"), 2);
}

void addImplementation(Registry& registry, const std::string& implementation, bool is_default, int number) {
  PluginDescription description;
  description.label = "camera";
  description.implementation = implementation;
  description.is_default = is_default;
  registry.add(PluginKind::kSensor, description, [number] { return std::make_shared<Plugin>(Plugin{number}); });
}

TEST(RegistryTest, TheDefaultIsWhatSaysSoInWhateverOrder) {
  for (const bool is_first : {true, false}) {
    Registry registry;
    if (is_first) {
      addImplementation(registry, "pinhole", true, 1);
    }
    addImplementation(registry, "blobs", false, 2);
    EXPECT_TRUE(registry.hasDefault(PluginKind::kSensor, "camera"));  // the declared one, or the only one
    if (!is_first) {
      addImplementation(registry, "pinhole", true, 1);
    }
    EXPECT_EQ(found(registry, PluginKind::kSensor, "camera"), 1);
    EXPECT_EQ(found(registry, PluginKind::kSensor, "camera", "blobs"), 2);
  }
}

TEST(RegistryTest, TwoWithoutADefaultHaveNone) {
  Registry registry;
  addImplementation(registry, "pinhole", false, 1);
  addImplementation(registry, "blobs", false, 2);
  EXPECT_FALSE(registry.hasDefault(PluginKind::kSensor, "camera"));
}

TEST(RegistryTest, TheSecondDefaultIsNamedAndDoesNotBecomeIt) {
  Registry registry;
  addImplementation(registry, "pinhole", true, 1);
  addImplementation(registry, "blobs", true, 2);
  EXPECT_EQ(found(registry, PluginKind::kSensor, "camera"), 1);
  EXPECT_EQ(found(registry, PluginKind::kSensor, "camera", "blobs"), 2);
  ASSERT_EQ(registry.conflicts().size(), 1U);
  EXPECT_TRUE(registry.conflicts()[0].is_about_default);
  EXPECT_EQ(describe(registry.conflicts()[0]), "sensor 'camera' has two default implementations; the first is used");
}

TEST(RegistryTest, WhatIsUnknownIsNotFound) {
  Registry registry;
  add(registry, PluginKind::kSensor, "footbot_camera", "color_blobs", 1);
  EXPECT_EQ(found(registry, PluginKind::kSensor, "footbot_kamera"), -1);
  EXPECT_EQ(found(registry, PluginKind::kSensor, "footbot_camera", "ideal"), -1);
  EXPECT_EQ(found(registry, PluginKind::kActuator, "footbot_camera"), -1);
  EXPECT_EQ(found(registry, PluginKind::kSensor, ""), -1);
}

TEST(RegistryTest, EveryMakeIsANewPlugin) {
  Registry registry;
  add(registry, PluginKind::kController, "drive", "", 1);
  const Registry::Entry& entry = *registry.find(PluginKind::kController, "drive");
  EXPECT_NE(makePlugin<Plugin>(entry), makePlugin<Plugin>(entry));
}

TEST(RegistryTest, TheSecondOfANameIsRefusedAndNamed) {
  Registry registry;
  add(registry, PluginKind::kController, "drive", "", 1);
  add(registry, PluginKind::kController, "drive", "", 2);
  add(registry, PluginKind::kSensor, "camera", "ideal", 3);
  add(registry, PluginKind::kSensor, "camera", "ideal", 4);
  add(registry, PluginKind::kSensor, "drive", "", 5);  // of another kind
  EXPECT_EQ(found(registry, PluginKind::kController, "drive"), 1);
  EXPECT_EQ(found(registry, PluginKind::kSensor, "camera", "ideal"), 3);
  EXPECT_EQ(found(registry, PluginKind::kSensor, "drive"), 5);
  ASSERT_EQ(registry.conflicts().size(), 2U);
  EXPECT_EQ(describe(registry.conflicts()[0]), "controller 'drive' is registered twice; the first is used");
  EXPECT_EQ(describe(registry.conflicts()[1]), "sensor 'camera ideal' is registered twice; the first is used");
  const Registry::Conflict& camera = registry.conflicts()[1];
  EXPECT_EQ(camera.kind, PluginKind::kSensor);
  EXPECT_EQ(camera.label, "camera");
  EXPECT_EQ(camera.implementation, "ideal");
  EXPECT_EQ(camera.first_library, camera.second_library) << "both are in this program";
}

TEST(RegistryTest, TwoLibrariesWithOneNameAreNamed) {
  EXPECT_EQ(describe({PluginKind::kEngine, "ground", "", "liba.so", "libb.so"}),
            "engine 'ground' is registered twice (liba.so, libb.so); the first is used");
}

TEST(RegistryTest, ListsAreSortedWhateverTheOrderOfLoading) {
  Registry forth;
  Registry back;
  const std::vector<std::pair<std::string, std::string>> all{{"b", "x"}, {"a", "z"}, {"a", "y"}, {"c", ""}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t k = all.size() - 1 - i;
    add(forth, PluginKind::kSensor, all[i].first, all[i].second, static_cast<int>(i), {"alias_of_" + all[i].first});
    add(back, PluginKind::kSensor, all[k].first, all[k].second, static_cast<int>(k));
  }
  EXPECT_EQ(forth.labels(PluginKind::kSensor), (Names{"a", "b", "c"}));
  EXPECT_EQ(back.labels(PluginKind::kSensor), forth.labels(PluginKind::kSensor));
  Names order;
  for (const Registry::Entry* entry : back.all(PluginKind::kSensor)) {
    order.push_back(entry->description.label + " " + entry->description.implementation);
  }
  EXPECT_EQ(order, (Names{"a y", "a z", "b x", "c "}));
  EXPECT_TRUE(forth.labels(PluginKind::kEngine).empty());
}

}  // namespace
}  // namespace swarmanoid
