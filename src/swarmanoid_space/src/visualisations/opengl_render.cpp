// The OpenGL window of thesis 3.6.2 is accepted in experiment files; rviz does its work now, so it draws nothing.
#include <string>

#include "swarmanoid_space/observer.hpp"

namespace swarmanoid {
namespace {

class OpenglRender final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "opengl_render";
    description.summary = "Accepted so that the thesis's files load; rviz is the viewer, and this draws nothing.";
    add(description, "window_size", Parameter::Type::kVector2, "1024, 768",
        "Width and height of the window, in pixels.");
    add(description, "window_title", Parameter::Type::kText, "", "Title of the window.");
    for (int camera = 0; camera < 10; ++camera) {
      const std::string number = std::to_string(camera);
      add(description, "camera_view_XYZ_" + number, Parameter::Type::kVector3, "0, 0, 0", "Place of a stored camera.");
      add(description, "camera_view_HPR_" + number, Parameter::Type::kVector3, "0, 0, 0",
          "Heading, pitch and roll of a stored camera.");
    }
    add(description, "use_textures", Parameter::Type::kBoolean, "true", "Whether surfaces have textures.");
    add(description, "use_shadows", Parameter::Type::kBoolean, "true", "Whether bodies cast shadows.");
    add(description, "write_frames", Parameter::Type::kBoolean, "false", "Whether frames are written to files.");
    add(description, "frame_directory", Parameter::Type::kText, "", "Folder for frames.");
    add(description, "frame_filename", Parameter::Type::kText, "frame_", "How the frames' file names begin.");
    return description;
  }

  void configure(const std::string& id, const Configuration&, const RunContext&) override { id_ = id; }
  void draw(const Space&) override {}

 private:
  static void add(PluginDescription& description, const std::string& name, Parameter::Type type,
                  const std::string& value, const std::string& text) {
    description.parameters.push_back(makeParameter(name, type, "", value, {}, text));
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::OpenglRender)
