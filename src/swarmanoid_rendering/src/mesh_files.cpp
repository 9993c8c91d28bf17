#include "mesh_files.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <stdexcept>
#include <utility>

#include "mesh_checks.hpp"
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

/// Checks the drawn faces, with all copies of nodes. @throws std::runtime_error if they would take too long to cut into
/// triangles and to draw
void checkFaces(const aiScene& scene) {
  std::vector<std::size_t> corners_of(scene.mNumMeshes);
  for (unsigned number = 0; number < scene.mNumMeshes; ++number) {
    const aiMesh& mesh = *scene.mMeshes[number];
    for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
      const unsigned corners = mesh.mFaces[face].mNumIndices;
      if (corners == 0 || corners > kMostCorners) {
        throw std::runtime_error("found a face of " + std::to_string(corners) + " corners, allowed: from 1 to " +
                                 std::to_string(kMostCorners));
      }
      corners_of[number] += corners;
    }
  }
  std::size_t corners = 0;
  for (std::vector<const aiNode*> left{scene.mRootNode}; !left.empty();) {
    const aiNode& node = *left.back();
    left.pop_back();
    left.insert(left.end(), node.mChildren, node.mChildren + node.mNumChildren);
    for (unsigned number = 0; number < node.mNumMeshes; ++number) {
      corners += corners_of[node.mMeshes[number]];
    }
  }
  if (corners > kMostDrawnCorners) {
    throw std::runtime_error("found " + std::to_string(corners) + " corners with all copies, allowed: at most " +
                             std::to_string(kMostDrawnCorners));
  }
}

/// Readable text of an error: the standard library gives only a name such as "std::bad_alloc" or "vector::reserve".
std::string reasonOf(const std::string& error) {
  const bool is_bare_name = error.substr(0, error.find(' ')).find("::") != std::string::npos;
  return is_bare_name ? "found counts that do not fit the file, or that need more memory than there is" : error;
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
  const auto refuse = [&resource](const std::string& reason) {
    throw std::runtime_error("mesh of a robot: '" + resource + "': " + reason);
  };
  Assimp::Importer importer;
  // keep the axes of Collada files, as rviz does
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = nullptr;
  std::vector<Triangle> triangles;
  try {
    checkMeshFile(file);
    scene = importer.ReadFile(file, 0);
    if (scene != nullptr && scene->mRootNode != nullptr) {
      checkFaces(*scene);
      // move all nodes into the frame of the file
      scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_PreTransformVertices);
    }
    if (scene != nullptr) {
      take(*scene, triangles);
    }
  } catch (const std::exception& error) {  // includes std::bad_alloc
    refuse(reasonOf(error.what()));
  }
  if (scene == nullptr) {
    refuse("cannot be read: " + reasonOf(importer.GetErrorString()));
  }
  return known_[resource] = std::move(triangles);
}

}  // namespace swarmanoid
