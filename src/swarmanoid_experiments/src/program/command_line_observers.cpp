#include "command_line_observers.hpp"

#include <filesystem>

#include "swarmanoid_recording/output/run_files.hpp"

namespace swarmanoid::program {

std::string fullName(const std::string& file) {
  return file.empty() ? file : std::filesystem::absolute(file).lexically_normal().string();
}

void addFromCommandLine(Simulation& simulation, const RunContext& context, const std::string& option,
                        const std::string& label, const std::string& file, const NamedValues& others) {
  Configuration parameters(label, "", {});
  parameters.set("file", fullName(file));
  for (const auto& [name, value] : others) {
    parameters.set(name, value);
  }
  addObserver(simulation, context, option, "command_line_" + label, parameters);
}

void addFrames(Simulation& simulation, const RunContext& context, const std::string& folder, std::uint64_t every) {
  Configuration parameters("opengl_render", "", {});
  parameters.set("write_frames", "true");
  parameters.set("frame_directory", fullName(folder));
  parameters.set("every", std::to_string(every));
  addObserver(simulation, context, "--frames", "command_line_opengl_render", parameters);
}

}  // namespace swarmanoid::program
