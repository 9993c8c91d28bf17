// Meshes: accepted files, and the exact reasons for rejecting files that would crash assimp or take minutes to draw.
#include <gtest/gtest.h>

#include "mesh_files_fixture.hpp"

namespace swarmanoid {
namespace {

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
  EXPECT_EQ(read("one.stl", std::string(80, '\0') + "\xff\xff\xff\x7f" + std::string(100, '\0')),
            "cannot be read: Failed to determine STL storage representation for " +
                (folder_.path() / "one.stl").string() + ".");
}

TEST_F(MeshFilesTest, RefusesMoreCornersThanCanBeDrawn) {
  constexpr int kFaces = 117648;
  const std::string face = std::string(1, '\xff') + std::string(255, '\0');
  EXPECT_EQ(read("one.ply",
                 "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar "
                 "y\nproperty uchar z\nelement face " +
                     std::to_string(kFaces) + "\nproperty list uchar uchar vertex_index\nend_header\n" +
                     std::string(3, '\0') + repeated(face, kFaces)),
            "found 30000240 corners with all copies, allowed: at most 30000000");
}

TEST_F(MeshFilesTest, SaysInPlainWordsWhatOverflows) {
  EXPECT_EQ(
      readCollada({{"polylist", "linestrips"}, {"polylist", "linestrips"}, {"<vcount>3</vcount><p>0 1 2</p>", "<p/>"}}),
      "cannot be read: found counts that do not fit the file, or that need more memory than there is");
}

}  // namespace
}  // namespace swarmanoid
