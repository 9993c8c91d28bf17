// Experiment files as text: malformed XML, texts that would take unbounded time and memory, lines, references.
#include <fstream>
#include <string>

#include "experiment_fixture.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"

namespace swarmanoid::test {
namespace {

class ExperimentTextTest : public ExperimentTest {};

TEST_F(ExperimentTextTest, RefusesWhatIsNoExperiment) {
  EXPECT_EQ(refusal({}, ""), "some.xml: found an empty file, allowed: an <ahss-config> element");
  EXPECT_EQ(refusal({}, "<!-- nothing -->"), "some.xml:1: found no well-formed XML: Start tag expected, '<' not found");
  EXPECT_EQ(refusal({}, std::string("<ahss-config>\n\0</ahss-config>", 29)),
            "some.xml:2: found a zero byte, allowed: text");
  EXPECT_EQ(refusal({}, "<?xml version='1.0' encoding='ISO-8859-1'?>\n<ahss-config>\xE9</ahss-config>"),
            "some.xml:2: found bytes that are no text in UTF-8, allowed: UTF-8");
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += text;
  }
  return result;
}

TEST_F(ExperimentTextTest, RefusesWhatWouldTakeTimeOrMemoryWithoutBounds) {
  EXPECT_EQ(refusal({}, "<ahss-config>\n" + repeated("<a>", 20000)),
            "some.xml:2: found elements nested more than 200 deep, allowed: fewer");
  EXPECT_EQ(refusal({}, "<ahss-config>\n<" + std::string(60000, 'a') + "/></ahss-config>"),
            "some.xml:2: found no well-formed XML: Name too long: NCName");
  EXPECT_EQ(refusal({}, "<ahss-config>\n&#" + std::string(30000, '7') + ";</ahss-config>"),
            "some.xml:2: found no well-formed XML: xmlParseCharRef: character reference out of bounds");
  // nested entities: the document type that would define them is refused
  EXPECT_EQ(refusal({}, "<!DOCTYPE a [<!ENTITY b 'c'><!ENTITY d '&b;&b;'>]><ahss-config>&d;</ahss-config>"),
            "some.xml:1: found '<!DOCTYPE', allowed: elements and comments <!-- ... -->");
  EXPECT_EQ(refusal({}, "<!DOCTYPE a SYSTEM '/etc/passwd'><ahss-config/>"),
            "some.xml:1: found '<!DOCTYPE', allowed: elements and comments <!-- ... -->");
}

TEST_F(ExperimentTextTest, RefusesADoubleHyphenInACommentWhereItStands) {
  const std::string refused = "found '--' in a comment, allowed: single hyphens, and '-->' as its end";
  EXPECT_EQ(refusal({}, "<ahss-config>\n<!--\n a--b --></ahss-config>"), "some.xml:3: " + refused);
  EXPECT_EQ(refusal({}, "<ahss-config><!-- a --><!-- b --->\n</ahss-config>"), "some.xml:1: " + refused);
  // the library took time quadratic in the length: 50 minutes for this comment
  EXPECT_EQ(refusal({}, "<ahss-config>\n<!--" + std::string(10'000'000, '-') + "></ahss-config>"),
            "some.xml:2: " + refused);
  EXPECT_EQ(refusal({}, "<ahss-config>\n<!-- a --"),
            "some.xml:2: found no well-formed XML: Double hyphen within comment: <!-- a ");
}

TEST_F(ExperimentTextTest, ReadsHyphensOutsideOfCommentsAndTagsInsideOfThem) {
  std::string text = kFile;
  text.insert(text.find("<arena"), "<!----><!-- - -> <a --><!--" + repeated(" b='c'", 1001) + "-->");
  EXPECT_EQ(refusal({}, text), "(accepted)");
  text.replace(text.find("500"), 3, "<![CDATA[<!-- -- -->]]>");
  EXPECT_EQ(refusal({}, text), "some.xml:4: maxclock: found '<!-- -- -->', allowed: a whole number from 1 to 1e+15");
}

/// Returns the number of read calls of this process so far; negative if the kernel does not count.
long readCalls() {
  std::ifstream io("/proc/self/io");
  for (std::string name, value; io >> name >> value;) {
    if (name == "syscr:") {
      return std::stol(value);
    }
  }
  return -1;
}

TEST_F(ExperimentTextTest, LooksForDeclaredLibrariesOnceHoweverManyVisualisationsThereAre) {
  std::string text = kFile;
  std::string many;
  for (int i = 0; i < 3000; ++i) {
    const std::string number = std::to_string(i);
    many += "<table id='many_" + number + "'/>";
  }
  text.insert(text.find("</visuali"), many);
  EXPECT_GE(parseExperiment(text, "some.xml").visualisations.size(), 3000U);  // loads the libraries
  const long before = readCalls();
  if (before < 0) {
    GTEST_SKIP() << "the kernel does not count";
  }
  parseExperiment(text, "some.xml");
  EXPECT_LT(readCalls() - before, 3000) << "some hundred files were read for each of them";
}

TEST_F(ExperimentTextTest, CountsLinesHoweverManyTheyAreAndWhereverATagEnds) {
  const std::string text =
      "<ahss-config>" + repeated("\n", 70000) + "<framework\n  speed='1'\n/>\n<arena/></ahss-config>";
  EXPECT_EQ(refusal({}, text), "some.xml:70001: found attribute 'speed', allowed: none (in <framework>)");
  EXPECT_EQ(refusal({}, "<ahss-config>" + repeated("\n", 70000) + "text &amp; text\n\n<arena/></ahss-config>"),
            "some.xml:70001: found the text 'text & text' in <ahss-config>, allowed: only elements");
}

TEST_F(ExperimentTextTest, ReadsReferencesAndSectionsOfCharacters) {
  std::string text = kFile;
  const auto read = [&](const std::string& maxclock) {
    std::string changed = text;
    changed.replace(changed.find("500"), 3, maxclock);
    return parseExperiment(changed, "some.xml").framework.max_clock;
  };
  EXPECT_EQ(read("2&#" + std::string(30000, '0') + "48;"), 20U);
  EXPECT_EQ(read("&#x33;<![CDATA[4]]>5"), 345U);
}

}  // namespace
}  // namespace swarmanoid::test
