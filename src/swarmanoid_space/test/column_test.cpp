// Columns: reused rows have the defaults in every column, lists have the length that models declare, and a visit of the
// state gives the named fields in the order of declaration.
#include "swarmanoid_space/state/column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {
namespace {

std::shared_ptr<const EntityModel> modelWithLeds(std::size_t count) {
  auto model = std::make_shared<EntityModel>(*lightModel());
  model->led_positions.assign(count, Eigen::Vector3d::Zero());
  return model;
}

/// Collects the names of fields.
class NameVisitor final : public StateVisitor {
 public:
  explicit NameVisitor(bool wants_detail) : wants_detail_(wants_detail) {}
  void beginEntity(Row row) override { names.push_back("entity " + std::to_string(toIndex(row))); }
  void beginWorld() override { names.emplace_back("world"); }
  void number(const FieldName& name, double) override { add(name); }
  void vector(const FieldName& name, const Eigen::Vector3d&) override { add(name); }
  void quaternion(const FieldName& name, const Eigen::Quaterniond&) override { add(name); }
  void colors(const FieldName& name, Span<const Color> values) override {
    names.push_back(std::string(name.group) + " " + std::to_string(values.size()));
  }
  void entity(const FieldName& name, Row) override { add(name); }
  void text(const FieldName& name, std::string_view) override { add(name); }
  void ordinal(std::size_t) override {}
  bool wantsDetail() const override { return wants_detail_; }

  std::vector<std::string> names;

 private:
  void add(const FieldName& name) {
    std::string text(name.group);
    for (const std::string_view part : {name.member, name.quantity}) {
      text += part.empty() ? "" : "/" + std::string(part);
    }
    names.push_back(text);
  }
  bool wants_detail_;
};

TEST(ColumnTest, ARowThatLivesAgainHasTheDefaultsInEveryColumn) {
  Entities entities;
  Column<int, WrittenIn::kControl> patience{entities.columns, {"patience"}, 7};
  Column<std::unique_ptr<int>> owned{entities.columns, {"owned"}};
  const Row row = entities.add("a", lightModel(), {}, {});
  EXPECT_EQ(patience[row], 7);
  patience[row] = 3;
  owned[row] = std::make_unique<int>(1);
  entities.remove(row);
  EXPECT_EQ(patience[row], 7) << "nothing of the deleted entity stays";
  EXPECT_EQ(owned[row], nullptr);
  patience[row] = 4;  // even a value written to an empty row is reset
  ASSERT_EQ(entities.add("b", lightModel(), {}, {}), row);
  EXPECT_EQ(patience[row], 7);
}

TEST(ColumnTest, AColumnThatComesLaterHasAllRowsAndOneThatGoesLeavesTheOthers) {
  Entities entities;
  const Row first = entities.add("a", lightModel(), {}, {});
  const std::size_t count = entities.columns.all().size();
  {
    Column<double, WrittenIn::kIndex> later{entities.columns, {"later"}};
    EXPECT_EQ(later[first], 0.0);
    later[first] = 1.0;
    EXPECT_EQ(entities.columns.all().size(), count + 1);
  }
  EXPECT_EQ(entities.columns.all().size(), count);
  const Row second = entities.add("b", lightModel(), {}, {});
  EXPECT_NE(first, second);
}

TEST(ListColumnTest, EachListIsAsLongAsTheModelSaysAndDefaultAgainWhenItsPlaceIsUsedAgain) {
  Space space;
  const Row three = space.entities.add("three", modelWithLeds(3), {}, {});
  const Row none = space.entities.add("none", modelWithLeds(0), {}, {});
  const Row five = space.entities.add("five", modelWithLeds(5), {}, {});
  EXPECT_EQ(space.leds[three].size(), 3U);
  EXPECT_TRUE(space.leds[none].empty());
  EXPECT_EQ(space.leds[five].size(), 5U);
  std::fill_n(space.leds[three].begin(), 3, colors::kRed);
  std::fill_n(space.leds[five].begin(), 5, colors::kBlue);
  EXPECT_EQ(std::count(space.leds[three].begin(), space.leds[three].end(), colors::kRed), 3);

  const Color* const place = space.leds[three].data();
  space.entities.remove(three);
  const Row again = space.entities.add("again", modelWithLeds(3), {}, {});
  EXPECT_EQ(space.leds[again].data(), place) << "memory does not grow";
  for (const Color& color : space.leds[again]) {
    EXPECT_EQ(color, colors::kBlack);
  }
  EXPECT_EQ(std::count(space.leds[five].begin(), space.leds[five].end(), colors::kBlue), 5) << "others keep theirs";
}

TEST(ColumnsTest, VisitorsGetWhatIsNamedInTheOrderOfDeclaration) {
  Space space;
  space.entities.add("lamp", modelWithLeds(2), {}, {});
  NameVisitor hashed(false);
  visitState(space, hashed);
  EXPECT_EQ(hashed.names,
            (std::vector<std::string>{"entity 0", "pose/position", "pose/orientation", "twist/linear", "twist/angular",
                                      "led 2", "gripped", "property/intensity", "world"}));
  NameVisitor recorded(true);
  visitState(space, recorded);
  EXPECT_EQ(recorded.names,
            (std::vector<std::string>{"entity 0", "pose/position", "pose/orientation", "twist/linear", "twist/angular",
                                      "color 1", "led 2", "gripped", "property/intensity", "outside", "world"}));
}

TEST(ColumnsTest, AColourIsHashedWhileItIsNotThatOfTheBeginning) {
  Space space;
  const Row row = space.entities.add("lamp", modelWithLeds(0), {}, colors::kRed);
  const std::uint64_t before = stateHash(space);
  space.entities.color[row] = colors::kBlue;
  NameVisitor hashed(false);
  visitState(space, hashed);
  EXPECT_EQ(std::count(hashed.names.begin(), hashed.names.end(), "color 1"), 1);
  NameVisitor recorded(true);
  visitState(space, recorded);
  EXPECT_EQ(std::count(recorded.names.begin(), recorded.names.end(), "color 1"), 1) << "not twice";
  EXPECT_NE(stateHash(space), before);
  space.entities.color[row] = colors::kRed;
  EXPECT_EQ(stateHash(space), before);
}

TEST(ColumnsTest, NoTwoColumnsOfTheSpaceHaveTheSameName) {
  const Space space;
  std::set<std::string> names;
  for (const ColumnBase* column : space.entities.columns.all()) {
    EXPECT_TRUE(names.insert(column->info().name).second) << column->info().name;
  }
  EXPECT_GE(names.size(), 12U);
}

}  // namespace
}  // namespace swarmanoid
