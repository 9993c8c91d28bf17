// Collada files that would crash assimp or make it read without end, and the exact reasons for their rejection.
#include <random>

#include "mesh_files_fixture.hpp"

namespace swarmanoid {
namespace {

constexpr const char* kIntoItself =
    "line 11: found a node that is copied into itself, or in more than 1000 steps, allowed: neither";
constexpr const char* kLeadsBack =
    "line 11: found the parameter 'x' of an effect, which leads back to itself, allowed: an image";

class ColladaCheckTest : public MeshFilesTest {
 protected:
  std::string readBeforeScenes(const std::string& elements) {
    return readCollada({{"<library_visual_scenes>", elements + "<library_visual_scenes>"}});
  }

  std::string readNode(const std::string& attributes, const std::string& url) {
    return readCollada({{"<node id=\"n\">", "<node " + attributes + "><instance_node url=\"" + url + "\"/>"}});
  }

  std::string readEffect(const std::string& parameters) {
    return readBeforeScenes("<library_effects><effect id='e'><profile_COMMON>" + parameters +
                            "</profile_COMMON></effect></library_effects>");
  }
};

TEST_F(ColladaCheckTest, RefusesNumbersThatColladaFilesCannotMean) {
  EXPECT_EQ(readCollada({{"stride=\"3\"", "stride=\"4\""}}),
            "line 6: found an accessor of 3 times 4 values from 0 on, allowed: those of its array, which has 9");
  EXPECT_EQ(readCollada({{"stride=\"3\"", "stride=\"3\" offset=\"1\""}}),
            "line 6: found an accessor of 3 times 3 values from 1 on, allowed: those of its array, which has 9");
  EXPECT_EQ(readCollada({{"stride=\"3\"", "stride=\"1\""}}),
            "line 6: found an accessor of 3 times 1 values from 0 on, allowed: those of its array, which has 9");
  const auto refusedNumber = [&](const std::string& from, const std::string& to) {
    const std::string reason = readCollada({{from, to}});
    return reason.substr(0, reason.find(", allowed: a whole number from 0 to "));
  };
  EXPECT_EQ(refusedNumber("stride=\"3\"", "stride=\"1000000000\""), "line 6: found stride of <accessor> '1000000000'");
  EXPECT_EQ(refusedNumber("count=\"3\"", "count=\"-1\""), "line 6: found count of <accessor> '-1'");
  EXPECT_EQ(refusedNumber("count=\"9\"", "count=\"4000000000\""), "line 5: found count of <float_array> '4000000000'");
  EXPECT_EQ(refusedNumber("polylist count=\"1\"", "polylist count=\"4000000000\""),
            "line 9: found count of <polylist> '4000000000'");
  EXPECT_EQ(refusedNumber("offset=\"0\"", "offset=\"4000000000\""), "line 9: found offset of <input> '4000000000'");
  EXPECT_EQ(readCollada({{"count=\"9\"", "count=\"10\""}}),
            "line 5: found count '10' of <float_array>, allowed: 9, as many as there are");
  EXPECT_EQ(readCollada({{"float_array", "Name_array"}, {"float_array", "Name_array"}}),
            "line 6: found an accessor of '#a', allowed: of a <float_array>");
  EXPECT_EQ(readCollada({{"<vcount>3</vcount>", ""}}),
            "line 9: found <p> without <vcount> before it, allowed: after the numbers of corners");
  EXPECT_EQ(readCollada({{"<p>0 1 2</p>", ""}}), "line 9: found 0 <p> in <polylist> of count 1, allowed: 1");
  EXPECT_EQ(readCollada({{"polylist count=\"1\"", "polygons count=\"2\""}, {"</polylist", "</polygons"}}),
            "line 9: found 1 <p> in <polygons> of count 2, allowed: 2");
  EXPECT_EQ(readCollada({{"polylist count=\"1\"", "polylist count=\"2\""}, {"<vcount>3", "<vcount>3 0"}}),
            "line 9: found a face of 0 corners, allowed: from 1 to 1000");
  EXPECT_EQ(readCollada({{"polylist", "trifans"}, {"polylist", "trifans"}, {"0 1 2</p>", "0 1</p>"}}),
            "line 9: found 2 indices in <trifans>, allowed: at least 3, for three corners");
  EXPECT_EQ(refusedNumber("0 1 2</p>", "0 x 2</p>"), "line 9: found an index 'x'");
  EXPECT_EQ(readCollada({{"0 1 2</p>", "0 1 3</p>"}}),
            "cannot be read: Invalid data index (3/3) in primitive specification");
}

TEST_F(ColladaCheckTest, RefusesNodesWithoutAnEnd) {
  const std::string node = "<node id=\"n\">";
  const std::string scenes = "<library_visual_scenes>";
  EXPECT_EQ(readCollada({{node, node + "<instance_node url='#n'/>"}}), kIntoItself);
  EXPECT_EQ(readCollada(
                {{node, node + "<instance_node url='#m'/>"},
                 {scenes, "<library_nodes><node name='m'><instance_node url='#n'/></node></library_nodes>" + scenes}}),
            kIntoItself);
  std::string copies = "<library_nodes>";
  for (int i = 0; i < 12; ++i) {
    copies += "<node id='m" + std::to_string(i) + "'>" +
              repeated("<instance_node url='#m" + std::to_string(i + 1) + "'/>", 10) + "</node>";
  }
  EXPECT_EQ(readCollada({{node, node + "<instance_node url='#m0'/>"},
                         {scenes, copies + "<node id='m12'/></library_nodes>" + scenes}}),
            "line 11: found more than 100000 nodes and instances with all copies, allowed: fewer");
  EXPECT_EQ(readCollada({{node, repeated("<node>", 20000) + node}, {"</node>", repeated("</node>", 20001)}}),
            "line 11: found elements nested more than 200 deep, allowed: fewer");
  std::string chain = "<library_nodes><node id='m0'/>";  // each is computed before the next one copies it
  for (int i = 1; i <= 6; ++i) {
    chain += "<node id='m" + std::to_string(i) + "'>" + repeated("<node>", 190) + "<instance_node url='#m" +
             std::to_string(i - 1) + "'/>" + repeated("</node>", 191);
  }
  EXPECT_EQ(readBeforeScenes(chain + "</library_nodes>"), kIntoItself);
}

TEST_F(ColladaCheckTest, ComparesIdsAsTheLibraryReadsThem) {
  EXPECT_EQ(readNode("id=\"a'&amp;\"", "#a&apos;&amp;"), kIntoItself);
  EXPECT_EQ(readNode("id='&lt;&gt;&quot;'", "#&lt;>&quot;"), kIntoItself);
  EXPECT_EQ(readNode("id='a\tb'", "#a b"), kIntoItself);
  EXPECT_EQ(readNode("id='a\r\nb'", "#a b"), kIntoItself);
  EXPECT_EQ(readNode("id='n'", "#&#110;"), kIntoItself);
  EXPECT_EQ(readNode("id='n'", "#&#x6e;"), kIntoItself);
  EXPECT_EQ(readNode("id='\u00fc\u20ac\U0001f41c'", "#&#xFC;&#8364;&#x1f41c;"), kIntoItself);
  for (const std::string reference : {"&", "&amp", "&#;", "&#x;", "&#-1;", "&#0;", "&#x110000;", "&n;"}) {
    EXPECT_EQ(readNode("id='n'", "#" + reference),
              "line 11: found '&' in '#" + reference + "', allowed: &amp;, &apos;, &gt;, &lt;, &quot; and &#number;");
  }
  EXPECT_EQ(readNode("id='n'", "#Scene"), kIntoItself);  // assimp's default name of scenes
  EXPECT_EQ(readNode("id='n'", "#s"), kIntoItself);
  EXPECT_EQ(readNode("", "#"), "line 11: found url='#' of <instance_node>, allowed: '#' and an id");
  EXPECT_EQ(readNode("id='n'", "other.dae#n"), "1 triangles");
  EXPECT_EQ(readCollada({{"url=\"#g\"", "url=\"#\""}}),
            "line 11: found url='#' of <instance_geometry>, allowed: '#' and an id");
  EXPECT_EQ(readCollada({{"id=\"a\"", ""}, {"source=\"#a\"", "source=\"#\""}}),
            "line 6: found source='#' of <accessor>, allowed: '#' and an id");
  EXPECT_EQ(readCollada({{"id=\"p\"", ""}, {"source=\"#p\"", "source=\"#\""}}),
            "line 8: found source='#' of <input>, allowed: '#' and an id");
  EXPECT_EQ(readCollada({{"id=\"a\"", "id=\"a'\""}, {"source=\"#a\" count=\"3\"", "source=\"#a&apos;\" count=\"4\""}}),
            "line 6: found an accessor of 4 times 3 values from 0 on, allowed: those of its array, which has 9");
}

TEST_F(ColladaCheckTest, EndsCommentsAndInstructionsAsTheLibraryDoes) {
  EXPECT_EQ(readCollada({{"<node id=\"n\">", "<node id=\"n\"><!--><a b='--><instance_node url=\"#n\"/><!-- '/>-->"}}),
            kIntoItself);
  EXPECT_EQ(readCollada({{"<?xml version=\"1.0\"?>", "<?xml version='?>"}}),
            "line 1: found an instruction with a quote that is not closed, allowed: name=\"value\"");
}

/// A node may have the name of the node it copies: ids of the library come first.
TEST_F(ColladaCheckTest, ReadsNodesWithNamesOfOthers) {
  EXPECT_EQ(readCollada({{"<node id=\"n\">", "<node name='m'><instance_node url='#m'/>"},
                         {"<library_visual_scenes>",
                          "<library_nodes><node id='m'><instance_geometry url='#g'/></node></library_nodes>"
                          "<library_visual_scenes>"}}),
            "2 triangles");
  EXPECT_EQ(readCollada({{"<node id=\"n\">", "<node name='m'><instance_node url='#m'/>"},
                         {"</COLLADA>", "</COLLADA><COLLADA><library_nodes><node id='m'/></library_nodes></COLLADA>"}}),
            "line 13: found <COLLADA> after the end of the first element, allowed: nothing");
}

TEST_F(ColladaCheckTest, RefusesParametersThatLeadBack) {
  const auto parameter = [](const std::string& sid, const std::string& content) {
    return "<newparam sid=\"" + sid + "\">" + content + "</newparam>";
  };
  EXPECT_EQ(readEffect(parameter("x", "<surface><init_from>y</init_from></surface>") +
                       parameter("y", "<sampler2D><source>x</source></sampler2D>")),
            kLeadsBack);
  EXPECT_EQ(readEffect(parameter("x", "<source>y'</source>") + parameter("y&apos;", "<init_from>x</init_from>")),
            kLeadsBack);
  EXPECT_EQ(readEffect(parameter("x", "<source>y </source>") + parameter("y\t", "<source>x</source>")), kLeadsBack);
  EXPECT_EQ(readEffect(parameter("x", "<source>y\r\n</source>") + parameter("y&#10;", "<source>x</source>")),
            "line 12" + std::string(kLeadsBack).substr(7));
  EXPECT_EQ(readEffect(parameter("x", "<source><![CDATA[x]]></source>")),
            "line 11: found more than a text in <source>, allowed: values");
  EXPECT_EQ(readEffect(parameter("x", "<source><!-- -->x</source>")),
            "line 11: found more than a text in <source>, allowed: values");
  EXPECT_EQ(readEffect(parameter("x", "<sampler2D url='#y'/>") + parameter("y", "<sampler2D url='#x'/>")), kLeadsBack);
  EXPECT_EQ(readEffect("<newparam><sampler2D/></newparam>"),
            "line 11: found a <newparam> without a sid, allowed: sid=\"...\"");
  EXPECT_EQ(readEffect(parameter("x", parameter("y", "<float/>") + "<source>x</source>")),
            "line 11: found <newparam> in another one, allowed: one after the other");
  EXPECT_EQ(readEffect(parameter("x", "<source>y</source>") + "<effect/>" + parameter("y", "<source>x</source>")),
            "line 11: found <effect> in another one, allowed: one after the other");
  EXPECT_EQ(readEffect(parameter("x", "<source>y</source>") + parameter("y", "<init_from>picture</init_from>")),
            "1 triangles");
}

TEST_F(ColladaCheckTest, RefusesMoreCornersThanCanBeDrawn) {
  std::string indices = "0";
  for (int i = 1; i < 1000; ++i) {
    indices += " " + std::to_string(i % 3);
  }
  const auto readCopies = [&](int copies) {
    return readCollada(
        {{"<vcount>3</vcount><p>0 1 2</p>", "<vcount>1000</vcount><p>" + indices + "</p>"},
         {"<library_visual_scenes>", "<library_nodes><node id='m'>" + repeated("<instance_geometry url='#g'/>", 1000) +
                                         "</node></library_nodes><library_visual_scenes>"},
         {"<node id=\"n\">", "<node id='n'>" + repeated("<instance_node url='#m'/>", copies)}});
  };
  EXPECT_EQ(readCopies(30), "line 11: found more than 30000000 corners with all copies, allowed: fewer");
  EXPECT_EQ(readCollada({{"<p>0 1 2</p>", "<p>" + repeated("0 ", 30'000'001) + "</p>"}}),
            "line 9: found more than 30000000 corners, allowed: fewer");
}

TEST_F(ColladaCheckTest, RefusesElementsThatFailAssertions) {
  EXPECT_EQ(readCollada({{"<node id=\"n\">", "<node id='n'><skew>1 2 3 4 5 6 7</skew>"}}),
            "line 11: found <skew>, allowed: other transformations");
  EXPECT_EQ(
      readCollada({{"1.4.1", "1.5.0"},
                   {"<library_geometries>", "<library_images><image id='i'><create><hex>" + repeated("a", 100000) +
                                                "</hex></create></image></library_images><library_geometries>"}}),
      "line 4: found <hex>, allowed: pictures in files of their own");
  EXPECT_EQ(readBeforeScenes("<library_animation_clips><animation_clip/></library_animation_clips>"),
            "line 11: found <animation_clip>, allowed: bodies that neither bend nor move by themselves");
  const auto readPicture = [&](const std::string& content) {
    return readBeforeScenes("<library_images><image id='i'>" + content + "</image></library_images>");
  };
  const std::string nameless = "line 11: found <init_from> without a name, allowed: the name of a picture";
  EXPECT_EQ(readPicture("<init_from/>"), nameless);
  EXPECT_EQ(readPicture("<init_from> \n</init_from>"), nameless);
  EXPECT_EQ(readPicture("<init_from>file://</init_from>"), nameless);
  EXPECT_EQ(readEffect("<newparam sid='x'><image><init_from/></image></newparam>"), nameless);
  EXPECT_EQ(readPicture("<?init_from?>"),
            "line 11: found an instruction in <image>, allowed: before the first element");
  EXPECT_EQ(readPicture("<init_from>a.png</init_from>"), "1 triangles");
  EXPECT_EQ(
      readCollada({{"1.4.1", "1.5.0"},
                   {"<library_visual_scenes>",
                    "<library_images><image id='i'><init_from><ref>a.png</ref></init_from></image></library_images>"
                    "<library_visual_scenes>"}}),
      "1 triangles");
  EXPECT_EQ(readCollada({{"<p>0 1 2</p>", "<extra><p>0 1 2</p></extra><p>0 1 2</p>"}}),
            "line 9: found 2 <p> in <polylist> of count 1, allowed: 1");
  EXPECT_EQ(readCollada({{"polylist count=\"1\"", "polygons count=\"0\""},
                         {"</polylist", "</polygons"},
                         {"<vcount>3</vcount><p>0 1 2</p>", "<p/>"}}),
            "line 9: found 1 <p> in <polygons> of count 0, allowed: 0");
}

TEST_F(ColladaCheckTest, RefusesWhatReadsBeyondArrays) {
  EXPECT_EQ(readCollada({{"<float_array id=\"a\" count=\"9\">0 0 0 0 0 3 0 5 0</float_array>",
                          "<float_array id=\"a\" count=\"9\"/>0 0 0 0 0 3 0 5 0"}}),
            "line 5: found count '9' of <float_array>, allowed: 0, as many as there are");
  EXPECT_EQ(readCollada({{"<param name=\"X\"/>", "<x>" + repeated("<param/>", 1000) + "</x><param name='X'/>"}}),
            "line 6: found more than 4 numbers in an <accessor>, allowed: fewer");
  EXPECT_EQ(readCollada({{"<param name=\"X\"/>", "<param name='X' type='float4x4'/>"}}),
            "line 6: found more than 4 numbers in an <accessor>, allowed: fewer");
  EXPECT_EQ(readCollada({{"<param name=\"X\"/>", "<accessor source='#a'/>" + repeated("<param/>", 1000)}}),
            "line 6: found <accessor> in another one, allowed: one after the other");
  EXPECT_EQ(readCollada({{"</polylist>", "</polylist><source id='p'/>"}}),
            "line 9: found a second <source> with the id 'p', allowed: one");
  EXPECT_EQ(readCollada({{"<input semantic=\"POSITION\" source=\"#p\"/>", ""}}),
            "line 9: found <polylist> before positions, allowed: after <vertices> with an input POSITION");
  EXPECT_EQ(readCollada({{"semantic=\"VERTEX\"", "semantic=\"OTHER\""}}),
            "line 9: found <p> without an input VERTEX before it, allowed: after it");
  EXPECT_EQ(readCollada({{"<input semantic=\"POSITION\"",
                          repeated("<input semantic='TEXCOORD' source='#p'/>", 32) + "<input semantic=\"POSITION\""}}),
            "line 8: found more than 32 <input>, allowed: fewer");
}

/// Files with moved, doubled or missing pieces are read, or rejected with a reason; none crashes assimp.
TEST_F(ColladaCheckTest, ReadsOrRefusesMutations) {
  std::string sample = kCollada;
  sample.insert(
      sample.find("<library_visual_scenes>"),
      "<library_images><image id=\"i\"><init_from>a.png</init_from></image></library_images><library_effects>"
      "<effect id=\"e\"><profile_COMMON><newparam sid=\"x\"><surface><init_from>i</init_from></surface></newparam>"
      "<newparam sid=\"y\"><sampler2D><source>x</source></sampler2D></newparam><technique><phong><diffuse><texture "
      "texture=\"y\"/></diffuse></phong></technique></profile_COMMON></effect></library_effects><library_materials>"
      "<material id=\"t\"><instance_effect url=\"#e\"/></material></library_materials><library_nodes><node id=\"m\">"
      "<instance_node url=\"#k\"/></node><node id=\"k\"/></library_nodes>");
  sample.insert(sample.find("<instance_geometry"), "<instance_node url=\"#m\"/>");
  std::minstd_rand random(1);
  const auto below = [&random](std::size_t limit) { return random() % limit; };
  int drawn = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = sample;
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      const auto piece = [&] {  // from one delimiter to another one near by
        const std::size_t from = text.find_first_of("<>\"# ", below(text.size() - 100));
        return std::pair(from, text.find_first_of("<>\"# ", from + 1 + below(60)) - from);
      };
      const auto [from, length] = piece();
      const auto [other, other_length] = piece();
      const std::string taken = text.substr(other, other_length);
      text.replace(from, below(2) == 0 ? length : 0, below(3) == 0 ? "" : taken);
    }
    const std::string result = read("one.dae", text);
    EXPECT_FALSE(result.empty()) << text;
    drawn += result.find(" triangles") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(drawn, 100);
}

}  // namespace
}  // namespace swarmanoid
