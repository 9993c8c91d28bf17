#include "swarmanoid_interface/plain_text.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdio>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {
namespace {

/// Groups of digits and a decimal comma, independent of the installed locales.
struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class PlainTextTest : public testing::Test {
 protected:
  PlainTextTest() { std::locale::global(std::locale(std::locale::classic(), new Commas)); }
  ~PlainTextTest() override { std::locale::global(std::locale::classic()); }
};

TEST_F(PlainTextTest, NumbersAreWrittenAsIfNobodyHadChangedTheLocale) {
  std::ostringstream spoilt;
  spoilt << 1234567 << " " << 0.5;
  EXPECT_EQ("1.234.567 0,5", spoilt.str());
  PlainTextStream text;
  text << 1234567 << " " << 0.5;
  EXPECT_EQ("1234567 0.5", text.str());
  EXPECT_EQ("from 0.5 to 12345.5", (Range{0.5, 12345.5}.toString()));
}

TEST_F(PlainTextTest, ShortNumbersAreThoseOfC) {
  for (const double value : {0.0, 1.0, -0.25, 1e-5, 1e-4, 123456.0, 1234567.0, 1.0 / 3.0, 1e300, -5e-324, M_PI}) {
    for (const int digits : {1, 3, 6, 15, 17}) {
      char expected[64];
      std::snprintf(expected, sizeof expected, "%.*g", digits, value);
      EXPECT_EQ(expected, shortNumber(value, digits));
    }
  }
}

TEST_F(PlainTextTest, TheLocaleIsPutBack) {
  restoreLocale();
  EXPECT_EQ(std::locale::classic(), std::locale());
  std::ostringstream text;
  text << 1234567 << " " << 0.5;
  EXPECT_EQ("1234567 0.5", text.str());
  const std::string before = std::setlocale(LC_ALL, nullptr);
  ASSERT_NE(nullptr, std::setlocale(LC_ALL, "C.UTF-8"));
  restoreLocale();
  EXPECT_EQ(before, std::setlocale(LC_ALL, nullptr));
}

}  // namespace
}  // namespace swarmanoid
