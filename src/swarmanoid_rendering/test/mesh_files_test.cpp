// Meshes: which files are drawn, and the exact reasons for those that assimp would crash on, or draw for minutes.
#include "../src/mesh_files.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

/// One triangle; in line 5 its numbers, in 6 their accessor, in 9 the triangle, in 11 its node.
constexpr const char* kCollada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="9">0 0 0 0 0 3 0 5 0</float_array><technique_common>
      <accessor source="#a" count="3" stride="3"><param name="X"/><param name="Y"/><param name="Z"/></accessor>
    </technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/><vcount>3</vcount><p>0 1 2</p></polylist>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";

using Changes = std::vector<std::pair<std::string, std::string>>;

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += text;
  }
  return result;
}

class MeshFilesTest : public testing::Test {
 protected:
  /// "3 triangles", or the reason why the file is refused.
  std::string read(const std::string& name, const std::string& text) {
    const std::string file = (folder_.path() / name).string();
    std::ofstream(file, std::ios::binary) << text;
    return read(file);
  }

  static std::string read(const std::string& file) {
    MeshFiles meshes;
    try {
      return std::to_string(meshes.read("file://" + file).size()) + " triangles";
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      const std::string start = "mesh of a robot: 'file://" + file + "': ";
      EXPECT_EQ(message.rfind(start, 0), 0U) << message;
      return message.substr(start.size());
    }
  }

  std::string readCollada(const Changes& changes) {
    std::string text = kCollada;
    for (const auto& [from, to] : changes) {
      const std::size_t place = text.find(from);
      EXPECT_NE(place, std::string::npos) << from;
      text.replace(place, from.size(), to);
    }
    return read("one.dae", text);
  }

  TemporaryFolder folder_{"meshes"};
};

TEST_F(MeshFilesTest, DrawsFourKindsOfFiles) {
  EXPECT_EQ(readCollada({}), "1 triangles");
  EXPECT_EQ(readCollada({{"<asset>", "<!-- - -- --><asset>"}}), "1 triangles");
  EXPECT_EQ(readCollada({{"<node id=\"n\">", "<node id='n'><instance_node url='#m'/>"},
                         {"<library_visual_scenes>",
                          "<library_nodes><node id='m'><instance_geometry url='#g'/></node></library_nodes>"
                          "<library_visual_scenes>"}}),
            "2 triangles");
  EXPECT_EQ(read("one.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"), "2 triangles");
  EXPECT_EQ(read("one.STL",
                 "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 3 0 0\nvertex 0 5 0\nendloop\n"
                 "endfacet\nendsolid one\n"),
            "1 triangles");
  EXPECT_EQ(read("one.glb", "glTF"), "found the ending '.glb', allowed: .dae, .obj, .ply, .stl");
  EXPECT_EQ(read("/nowhere/one.stl"), "found no regular file, allowed: a file that can be read");
  EXPECT_EQ(read("/dev/zero"), "found no regular file, allowed: a file that can be read");
}

TEST_F(MeshFilesTest, RefusesNumbersThatColladaFilesCannotMean) {
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
  EXPECT_EQ(readCollada({{"<p>0 1 2</p>", ""}}),
            "line 9: found 0 <p> with indices in <polylist> of count 1, allowed: 1");
  EXPECT_EQ(readCollada({{"polylist count=\"1\"", "polygons count=\"2\""}, {"</polylist", "</polygons"}}),
            "line 9: found 1 <p> with indices in <polygons> of count 2, allowed: 2");
  EXPECT_EQ(readCollada({{"polylist count=\"1\"", "polylist count=\"2\""}, {"<vcount>3", "<vcount>3 0"}}),
            "found a face of 0 corners, allowed: from 1 to 1000");
  EXPECT_EQ(readCollada({{"polylist", "trifans"}, {"polylist", "trifans"}, {"0 1 2</p>", "0 1</p>"}}),
            "line 9: found 2 indices in <trifans>, allowed: at least 3, for three corners");
  EXPECT_EQ(refusedNumber("0 1 2</p>", "0 x 2</p>"), "line 9: found an index 'x'");
  EXPECT_EQ(readCollada({{"0 1 2</p>", "0 1 3</p>"}}),
            "cannot be read: Invalid data index (3/3) in primitive specification");
}

TEST_F(MeshFilesTest, RefusesNodesWithoutAnEnd) {
  const std::string into_itself =
      "line 11: found a node that is copied into itself, or in more than 1000 steps, allowed: neither";
  const std::string node = "<node id=\"n\">";
  const std::string scenes = "<library_visual_scenes>";
  EXPECT_EQ(readCollada({{node, node + "<instance_node url='#n'/>"}}), into_itself);
  EXPECT_EQ(readCollada(
                {{node, node + "<instance_node url='#m'/>"},
                 {scenes, "<library_nodes><node name='m'><instance_node url='#n'/></node></library_nodes>" + scenes}}),
            into_itself);
  EXPECT_EQ(readCollada({{node, node + "<instance_node url='#&#110;'/>"}}),
            "line 11: found url='#&#110;' of <instance_node>, allowed: a text without '&#'");
  std::string copies = "<library_nodes>";
  for (int i = 0; i < 12; ++i) {
    copies += "<node id='m" + std::to_string(i) + "'>" +
              repeated("<instance_node url='#m" + std::to_string(i + 1) + "'/>", 10) + "</node>";
  }
  EXPECT_EQ(readCollada({{node, node + "<instance_node url='#m0'/>"},
                         {scenes, copies + "<node id='m12'/></library_nodes>" + scenes}}),
            "line 11: found more than 100000 nodes with all copies, allowed: fewer");
  EXPECT_EQ(readCollada({{node, repeated("<node>", 20000) + node}, {"</node>", repeated("</node>", 20001)}}),
            "line 11: found elements nested more than 200 deep, allowed: fewer");
  EXPECT_EQ(
      readCollada({{scenes,
                    "<library_effects><effect id='e'><newparam sid='x'><init_from>y</init_from></newparam><newparam "
                    "sid='y'><source>x</source></newparam></effect></library_effects>" +
                        scenes}}),
      "line 11: found the parameter 'x' of an effect, which leads back to itself, allowed: an image");
}

TEST_F(MeshFilesTest, RefusesFacesThatTakeMinutesToCut) {
  constexpr int kCorners = 300000;
  std::string vertices;
  std::string face = "f";
  for (int i = 1; i <= kCorners; ++i) {
    vertices += "v 0 " + std::to_string(i) + " 0\n";
    face += " " + std::to_string(i);
  }
  EXPECT_EQ(read("one.obj", vertices + face + "\n"), "found a face of 300000 corners, allowed: from 1 to 1000");
  EXPECT_EQ(readCollada({{"<vcount>3", "<vcount>300000"}}),
            "line 9: found a number of corners '300000', allowed: a whole number from 0 to 1000");
  EXPECT_EQ(readCollada({{"<vcount>3", "<vcount><!-- -->300000"}}),
            "line 9: found more than a text in <vcount>, allowed: values");
}

TEST_F(MeshFilesTest, RefusesCountsOfOtherFiles) {
  const auto ply = [](const std::string& vertices) {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
           "vertex_index\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";
  };
  EXPECT_EQ(read("one.ply", ply("3")), "1 triangles");
  EXPECT_EQ(read("one.ply", ply("4000000000")),
            "line 3: count of vertex: found '4000000000', allowed: a whole number from 0 to 187");
  EXPECT_EQ(
      read("one.stl", std::string(80, '\0') + "\xff\xff\xff\x7f" + std::string(100, '\0')).rfind("cannot be read: ", 0),
      0U);
}

}  // namespace
}  // namespace swarmanoid
