#include "mesh_files.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

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
  const std::size_t slash = resource.find('/', package.size());
  return slash == std::string::npos
             ? ""
             : findShared(resource.substr(package.size(), slash - package.size()), resource.substr(slash + 1));
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
  const auto [entry, is_new] = known_.try_emplace(resource);
  if (!is_new) {
    return entry->second;
  }
  Assimp::Importer importer;
  // all nodes in the frame of the file
  const aiScene* scene = importer.ReadFile(fileOf(resource), aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (scene == nullptr) {
    known_.erase(entry);
    throw std::runtime_error("mesh '" + resource + "': " + importer.GetErrorString());
  }
  take(*scene, entry->second);
  return entry->second;
}

}  // namespace swarmanoid
