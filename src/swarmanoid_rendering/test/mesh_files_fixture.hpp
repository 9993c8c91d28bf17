/// A Collada file of one triangle, and the results of reading changed copies of it.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "../src/mesh_files.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {

/// One triangle. Line 5 has its numbers, line 6 their accessor, line 9 the triangle, line 11 its node.
inline constexpr const char* kCollada = R"(<?xml version="1.0"?>
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

inline std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += text;
  }
  return result;
}

class MeshFilesTest : public testing::Test {
 protected:
  /// "3 triangles", or the reason why the file is rejected.
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

}  // namespace swarmanoid
