#include "mesh_checks.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/read_file.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

/// Checks counts such as "element vertex 1000" in the header of a PLY file: assimp reserves memory for them before it
/// reads the elements, and each element needs at least one byte.
void checkPly(const std::string& text) {
  std::istringstream head(text.substr(0, text.find("end_header")));
  int number = 0;
  for (std::string line; std::getline(head, line);) {
    ++number;
    std::istringstream words(line);
    std::string element, name, count;
    if (words >> element >> name >> count && element == "element") {
      parseInteger(count, "count of " + name, {"line " + std::to_string(number), 0},
                   {0.0, static_cast<double>(text.size())});
    }
  }
}

}  // namespace

void checkMeshFile(const std::string& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    throw std::runtime_error("found no regular file, allowed: a file that can be read");
  }
  if (const std::uintmax_t size = fs::file_size(file, ignored); size > kLongestMesh) {
    throw std::runtime_error("found " + std::to_string(size) + " bytes, allowed: at most " +
                             std::to_string(kLongestMesh));
  }
  std::string ending = fs::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".dae") {
    checkCollada(readFile(file, kLongestMesh));
  } else if (ending == ".ply") {
    checkPly(readFile(file, kLongestMesh));
  } else if (ending != ".stl" && ending != ".obj") {
    throw std::runtime_error("found the ending '" + ending + "', allowed: .dae, .obj, .ply, .stl");
  }
}

}  // namespace swarmanoid
