/// Checks of a mesh file before assimp reads it. Assimp's readers trust numbers in files: they read beyond arrays,
/// follow circular references, and reserve as much memory as the file states.
#pragma once

#include <cstddef>
#include <string>

namespace swarmanoid {

constexpr std::size_t kLongestMesh = std::size_t{1} << 28U;  ///< [bytes]
/// Corners of one face: the time to cut it into triangles grows with their square.
constexpr std::size_t kMostCorners = 1000;
/// Corners of all faces, with all copies by instances: assimp gives each corner a vertex of its own.
constexpr std::size_t kMostDrawnCorners = 30'000'000;

/// @throws std::runtime_error with the values found and allowed
void checkMeshFile(const std::string& file);

/// Checks the text of a Collada file. @throws std::runtime_error "line N: found ..., allowed: ..."
void checkCollada(const std::string& text);

}  // namespace swarmanoid
