#include "../src/ros/marker_geometry.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;
using visualization_msgs::Marker;

geometry_msgs::Point point(double x, double y, double z) {
  geometry_msgs::Point made;
  made.x = x;
  made.y = y;
  made.z = z;
  return made;
}

/// At (1, 2, 3), turned by 90 degrees to the left.
Marker marker(int type, const Vector3d& scale) {
  Marker made;
  made.type = type;
  made.pose.position = point(1.0, 2.0, 3.0);
  made.pose.orientation.w = made.pose.orientation.z = std::sqrt(0.5);
  made.scale.x = scale.x();
  made.scale.y = scale.y();
  made.scale.z = scale.z();
  made.color.r = 0.25F;
  made.color.a = 0.5F;
  return made;
}

Geometry geometryOf(const Marker& marker) {
  MeshFiles meshes;
  Geometry geometry;
  const Eigen::Isometry3d frame(Eigen::Translation3d(10.0, 0.0, 0.0));
  addMarker(marker, frame, meshes, geometry);
  return geometry;
}

/// Bounding box of all corners.
Eigen::AlignedBox3f bounds(const Geometry& geometry) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& corner : geometry.corners) {
    box.extend(corner);
  }
  return box;
}

TEST(MarkerGeometryTest, SolidsHaveTheirPlaceSizeAndColour) {
  for (const int type : {Marker::CUBE, Marker::CYLINDER, Marker::SPHERE}) {
    const Geometry geometry = geometryOf(marker(type, {0.4, 0.2, 0.6}));
    const Eigen::AlignedBox3f box = bounds(geometry);
    EXPECT_TRUE(box.center().isApprox(Eigen::Vector3f(11.0F, 2.0F, 3.0F), 1e-5F)) << type;
    EXPECT_TRUE(box.sizes().isApprox(Eigen::Vector3f(0.2F, 0.4F, 0.6F), 1e-2F)) << type << " " << box.sizes();
    for (const Tint& tint : geometry.triangle_tints) {
      ASSERT_EQ(tint, Tint(0.25F, 0.0F, 0.0F, 0.5F));
    }
  }
  const Geometry ball = geometryOf(marker(Marker::SPHERE, Vector3d::Constant(0.6)));
  ASSERT_EQ(ball.balls.size(), 1U);
  EXPECT_EQ(ball.balls[0], Eigen::Vector4f(11.0F, 2.0F, 3.0F, 0.3F));
}

TEST(MarkerGeometryTest, ListsHaveAPlaceAndAColourEach) {
  Marker list = marker(Marker::SPHERE_LIST, Vector3d::Constant(0.1));
  list.points = {point(0.5, 0.0, 0.0), point(0.0, 0.5, 0.0)};
  list.colors.resize(2);
  list.colors[1].g = 1.0F;
  const Geometry balls = geometryOf(list);
  ASSERT_EQ(balls.balls.size(), 2U);
  EXPECT_TRUE(balls.balls[0].isApprox(Eigen::Vector4f(11.0F, 2.5F, 3.0F, 0.05F)));
  EXPECT_TRUE(balls.balls[1].isApprox(Eigen::Vector4f(10.5F, 2.0F, 3.0F, 0.05F)));
  EXPECT_EQ(balls.ball_tints[1], Tint(0.0F, 1.0F, 0.0F, 0.0F));

  list.colors.pop_back();  // fewer colours than points: the marker's colour applies
  EXPECT_EQ(geometryOf(list).ball_tints[1], Tint(0.25F, 0.0F, 0.0F, 0.5F));
  list.type = Marker::POINTS;
  EXPECT_EQ(geometryOf(list).balls, balls.balls);
  list.type = Marker::CUBE_LIST;
  EXPECT_EQ(geometryOf(list).triangles.size(), 2U * 12U);
}

TEST(MarkerGeometryTest, LinesAreRodsByPairsOrOneAfterTheOther) {
  Marker lines = marker(Marker::LINE_LIST, {0.02, 0.0, 0.0});
  lines.points = {point(0.0, 0.0, 0.0), point(0.7, 0.0, 0.0), point(1.0, 0.0, 0.0), point(1.0, 0.0, 0.0)};
  const Geometry pairs = geometryOf(lines);
  ASSERT_EQ(pairs.rods.size(), 2U) << "one that has no length is none";
  EXPECT_TRUE(pairs.rods[1].isApprox(Eigen::Vector4f(11.0F, 2.7F, 3.0F, 0.01F)));
  lines.type = Marker::LINE_STRIP;
  EXPECT_EQ(geometryOf(lines).rod_tints.size(), 2U);
}

TEST(MarkerGeometryTest, TrianglesAreScaledAndTextsAndWhatIsDeletedAreNothing) {
  Marker triangles = marker(Marker::TRIANGLE_LIST, {2.0, 1.0, 1.0});
  triangles.points = {point(0.0, 0.0, 0.0), point(1.0, 0.0, 0.0), point(0.0, 1.0, 0.0)};
  const Geometry geometry = geometryOf(triangles);
  ASSERT_EQ(geometry.triangles.size(), 1U);
  EXPECT_TRUE(geometry.corners[1].isApprox(Eigen::Vector3f(11.0F, 4.0F, 3.0F)));
  triangles.action = Marker::DELETE;
  EXPECT_TRUE(geometryOf(triangles).triangles.empty());
  EXPECT_TRUE(geometryOf(marker(Marker::TEXT_VIEW_FACING, Vector3d::Ones())).triangles.empty());
}

TEST(MarkerGeometryTest, MeshesAreReadFromTheirFiles) {
  const TemporaryFolder folder("meshes");
  const std::string file = (folder.path() / "one.stl").string();
  std::ofstream(file)
      << "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 3 0 0\nvertex 0 5 0\nendloop\n"
         "endfacet\nendsolid one\n";
  Marker mesh = marker(Marker::MESH_RESOURCE, Vector3d::Constant(0.1));
  mesh.mesh_resource = "file://" + file;
  const Geometry geometry = geometryOf(mesh);
  ASSERT_EQ(geometry.triangles.size(), 1U);
  EXPECT_TRUE(bounds(geometry).sizes().isApprox(Eigen::Vector3f(0.5F, 0.3F, 0.0F), 1e-5F));
  EXPECT_EQ(geometry.triangle_tints[0], Tint(0.25F, 0.0F, 0.0F, 0.5F));

  mesh.mesh_resource = "package://nobody/no.dae";
  try {
    geometryOf(mesh);
    FAIL() << "a mesh that is not there";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        error.what(),
        "mesh of a robot: found 'package://nobody/no.dae', allowed: a file, and there is no share/nobody/no.dae "
        "in any prefix of CMAKE_PREFIX_PATH");
  }
}

/// A triangle from the origin, 3 up and 5 along y, in a file whose <up_axis> is `up`.
std::string collada(const std::string& up) {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>)" +
         up + R"(</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="9">0 0 0 0 0 3 0 5 0</float_array><technique_common>
      <accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
    </technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";
}

TEST(MarkerGeometryTest, AxesOfMeshesAreTakenAsTheyAre) {
  const TemporaryFolder folder("meshes");
  for (const char* up : {"Z_UP", "Y_UP"}) {
    const std::string file = (folder.path() / (std::string(up) + ".dae")).string();
    std::ofstream(file) << collada(up);
    Marker mesh = marker(Marker::MESH_RESOURCE, Vector3d::Ones());
    mesh.mesh_resource = "file://" + file;
    // turned by 90 degrees to the left, y becomes -x
    EXPECT_TRUE(bounds(geometryOf(mesh)).sizes().isApprox(Eigen::Vector3f(5.0F, 0.0F, 3.0F), 1e-5F)) << up;
  }
}

}  // namespace
}  // namespace swarmanoid
