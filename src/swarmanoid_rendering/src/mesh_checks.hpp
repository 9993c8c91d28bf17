/// What is refused of a mesh file before assimp reads it: its readers trust numbers in files, read beyond arrays,
/// follow references in circles and reserve what files say that they need.
#pragma once

#include <cstddef>
#include <string>

namespace swarmanoid {

constexpr std::size_t kLongestMesh = std::size_t{1} << 28U;  ///< [bytes]
/// Corners of one face: to cut it into triangles takes the square of them in time.
constexpr std::size_t kMostCorners = 1000;
/// Corners of all faces, with all copies that instances make: assimp gives each a vertex of its own.
constexpr std::size_t kMostDrawnCorners = 30'000'000;

/// @throws std::runtime_error what was found, and what is allowed
void checkMeshFile(const std::string& file);

/// A Collada file, as the sum of its text. @throws std::runtime_error "line N: found ..., allowed: ..."
void checkCollada(const std::string& text);

}  // namespace swarmanoid
