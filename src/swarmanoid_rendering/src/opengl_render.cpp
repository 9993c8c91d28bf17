// The graphical visualisation of thesis 3.6.2. Rviz is its window; this observer writes its frames, with or without a
// display.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "frame_files.hpp"
#include "swarmanoid_rendering/world_view.hpp"
#include "swarmanoid_space/models/limits.hpp"
#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/picture_source.hpp"

namespace swarmanoid {
namespace {

constexpr double kRadPerDeg = M_PI / 180.0;
constexpr int kCameras = 10;
constexpr Range kPixels{1.0, 8192.0};
constexpr int kWidth = 1024;
constexpr int kHeight = 768;
constexpr double kFieldOfView = M_PI / 3.0;

std::string placeName(int camera) { return "camera_view_XYZ_" + std::to_string(camera); }
std::string anglesName(int camera) { return "camera_view_HPR_" + std::to_string(camera); }

PluginDescription descriptionOfRender() {
  using Type = Parameter::Type;
  PluginDescription description;
  description.label = "opengl_render";
  description.summary = "Writes pictures of the run, as numbered PNG files; rviz is the window.";
  const auto add = [&](const std::string& name, Type type, const std::string& unit, const std::string& value,
                       Range range, const std::string& text) {
    description.parameters.push_back(makeParameter(name, type, unit, value, range, text));
  };
  add("window_size", Type::kVector2, "", std::to_string(kWidth) + ", " + std::to_string(kHeight), kPixels,
      "Width and height of a frame, in whole pixels.");
  add("window_title", Type::kText, "", "", {}, "Accepted without effect.");
  for (int camera = 0; camera < kCameras; ++camera) {
    add(placeName(camera), Type::kVector3, "m", "0, 0, 0", limits::kCoordinate,
        "Place of a camera; 0, 0, 0: where it sees the whole arena, from the south.");
    add(anglesName(camera), Type::kAngles3, "deg", "0, 0, 0", limits::kTurn,
        "Its heading (to the left from x), pitch (upwards) and roll.");
  }
  add("camera", Type::kInteger, "", "0", {0.0, kCameras - 1.0}, "Which camera takes the frames.");
  add("field_of_view", Type::kAngle, "deg", "60", {1.0, 170.0}, "From the left to the right border of a frame.");
  add("use_textures", Type::kBoolean, "", "true", {}, "Whether the floor has its image.");
  add("use_shadows", Type::kBoolean, "", "true", {}, "Whether bodies cast shadows.");
  add("write_frames", Type::kBoolean, "", "false", {}, "Whether frames are written.");
  add("every", Type::kInteger, "ticks", "1", {1.0, 1e9}, "Ticks from one frame to the next.");
  add("frame_directory", Type::kText, "", "", {}, "Folder for frames, made if it is not there.");
  add("frame_filename", Type::kText, "", "frame_", {}, "How the frames' names begin; a number of six digits follows.");
  return description;
}

class OpenglRender final : public Observer, public PictureSource {
 public:
  static PluginDescription describe() { return descriptionOfRender(); }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    readSize(parameters);
    camera_ = cameraOf(parameters);
    sees_all_ = camera_.position.isZero(0.0);
    if (sees_all_) {
      refuseWithoutPlace(parameters);
    }
    options_.has_shadows = parameters.boolean("use_shadows", true);
    has_textures_ = parameters.boolean("use_textures", true);
    threads_ = context.experiment == nullptr ? 1 : static_cast<int>(context.experiment->framework.threads);
    every_ = static_cast<std::uint64_t>(parameters.integer("every", 1));
    if (parameters.boolean("write_frames", false)) {
      view_.emplace(has_textures_);
      tracer_.emplace(threads_);
      files_.emplace(context, parameters, id);
    }
  }

  void draw(const Space& space) override {
    if (!files_) {
      return;
    }
    view_->follow(space);
    if (space.tick % every_ != 0) {
      return;
    }
    files_->write(toPng(picture(space)));
  }

  /// Without `draw` in each tick nothing notes changes of the fixed part, so all is shown anew.
  Pixels take(const Space& space) override {
    if (!tracer_) {
      tracer_.emplace(threads_);
    }
    view_.emplace(has_textures_);
    view_->follow(space);
    Picture taken = picture(space);
    return {taken.width, taken.height, std::move(taken.rgb)};
  }

 private:
  Picture picture(const Space& space) {
    if (sees_all_) {
      const Eigen::Vector3d far = space.farCorner();
      camera_ = overview(
          {Eigen::Vector3d(space.corner.x(), space.corner.y(), 0.0), Eigen::Vector3d(far.x(), far.y(), topOf(space))},
          camera_.field_of_view, static_cast<double>(width_) / height_);
      sees_all_ = false;  // the camera stays there
    }
    view_->show(space, *tracer_);
    return tracer_->render(camera_, width_, height_, options_);
  }

  /// Highest z of the movable entities [m]: arenas are often far higher.
  static double topOf(const Space& space) {
    double top = 0.0;
    for (const Row row : space.entities.order) {
      const EntityModel& model = *space.entities.model[row];
      top = model.is_movable ? std::max(top, space.entities.pose[row].position.z() + model.highest) : top;
    }
    return top;
  }

  void readSize(const Configuration& parameters) {
    if (!parameters.has("window_size")) {
      return;
    }
    const Eigen::Vector2d size = parameters.vector2("window_size");
    width_ = static_cast<int>(size.x());
    height_ = static_cast<int>(size.y());
    if (size != Eigen::Vector2d(width_, height_)) {
      throw ConfigError(parameters.find("window_size")->location(),
                        "window_size: found '" + parameters.text("window_size") + "', allowed: whole numbers");
    }
  }

  /// @throws ConfigError for settings of a camera without a position
  static void refuseWithoutPlace(const Configuration& parameters) {
    const int number = static_cast<int>(parameters.integer("camera", 0));
    for (const std::string& name : {std::string("camera"), anglesName(number)}) {
      const bool is_default = name == "camera" ? number == 0 : parameters.vector3(name, {0.0, 0.0, 0.0}).isZero(0.0);
      if (!is_default) {
        throw ConfigError(parameters.find(name)->location(),
                          name + ": found '" + parameters.text(name) + "', allowed: with " + placeName(number));
      }
    }
  }

  static Camera cameraOf(const Configuration& parameters) {
    const int number = static_cast<int>(parameters.integer("camera", 0));
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    const Eigen::Vector3d angles = parameters.vector3(anglesName(number), origin) * kRadPerDeg;
    return {parameters.vector3(placeName(number), origin), angles.x(), angles.y(), angles.z(),
            parameters.angle("field_of_view", kFieldOfView)};
  }

  int width_ = kWidth;
  int height_ = kHeight;
  Camera camera_;
  bool sees_all_ = false;  // the first frame places the camera so that it sees the whole arena
  RayTracer::Options options_;
  bool has_textures_ = true;
  int threads_ = 1;
  std::uint64_t every_ = 1;
  std::optional<WorldView> view_;  // these are set only if frames are written or pictures are taken
  std::optional<RayTracer> tracer_;
  std::optional<FrameFiles> files_;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::OpenglRender)
