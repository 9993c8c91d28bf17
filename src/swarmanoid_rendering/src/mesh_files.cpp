#include "mesh_files.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <stdexcept>

#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {
namespace {

std::string fileOf(const std::string& resource) {
  const std::string package = "package://";
  const std::string file = "file://";
  if (resource.rfind(file, 0) == 0) {
    return resource.substr(file.size());
  }
  if (resource.rfind(package, 0) != 0) {
    return resource;
  }
  const std::string path = resource.substr(package.size());  // PACKAGE/FILE
  const std::size_t slash = std::min(path.find('/'), path.size());
  std::string file_there = findShared(path.substr(0, slash), path.substr(std::min(slash + 1, path.size())));
  if (slash == path.size() || file_there.empty()) {
    throw std::runtime_error("mesh of a robot: found '" + resource + "', allowed: a file, and there is no share/" +
                             path + " in any prefix of CMAKE_PREFIX_PATH");
  }
  return file_there;
}

std::optional<Tint> tintOf(const aiScene& scene, const aiMesh& mesh) {
  aiColor4D color;
  if (mesh.mMaterialIndex >= scene.mNumMaterials ||
      aiGetMaterialColor(scene.mMaterials[mesh.mMaterialIndex], AI_MATKEY_COLOR_DIFFUSE, &color) != AI_SUCCESS) {
    return std::nullopt;
  }
  return Tint(color.r, color.g, color.b, color.a);
}

void take(const aiScene& scene, std::vector<MeshFiles::Triangle>& triangles) {
  for (unsigned number = 0; number < scene.mNumMeshes; ++number) {
    const aiMesh& mesh = *scene.mMeshes[number];
    const std::optional<Tint> tint = tintOf(scene, mesh);
    for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
      if (mesh.mFaces[face].mNumIndices != 3) {
        continue;  // points and lines
      }
      MeshFiles::Triangle triangle;
      triangle.tint = tint;
      for (unsigned corner = 0; corner < 3; ++corner) {
        const aiVector3D& at = mesh.mVertices[mesh.mFaces[face].mIndices[corner]];
        triangle.corners[corner] = {at.x, at.y, at.z};
      }
      triangles.push_back(triangle);
    }
  }
}

}  // namespace

const std::vector<MeshFiles::Triangle>& MeshFiles::read(const std::string& resource) {
  if (const auto known = known_.find(resource); known != known_.end()) {
    return known->second;
  }
  const std::string file = fileOf(resource);
  Assimp::Importer importer;
  // rviz leaves the axes of Collada files as they are, too
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  // all nodes in the frame of the file
  const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (scene == nullptr) {
    throw std::runtime_error("mesh of a robot: '" + resource + "' cannot be read: " + importer.GetErrorString());
  }
  std::vector<Triangle>& triangles = known_[resource];
  take(*scene, triangles);
  return triangles;
}

}  // namespace swarmanoid
