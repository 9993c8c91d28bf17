#include "swarmanoid_rendering/ray_tracer.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

#include "embree.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kMostLayers = 32;   // translucent surfaces along a ray
constexpr float kLeast = 0.004F;  // smallest visible fraction of a colour: one of 256 steps
constexpr std::array<RTCGeometryType, 3> kKinds = {RTC_GEOMETRY_TYPE_TRIANGLE, RTC_GEOMETRY_TYPE_SPHERE_POINT,
                                                   RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE};

struct Hit {
  float distance = std::numeric_limits<float>::infinity();
  bool is_rod = false;
  Vector3f normal = Vector3f::Zero();  // towards the origin of the ray
  Tint tint = Tint::Zero();

  bool isOne() const { return std::isfinite(distance); }
};

/// Offset from a surface at which a ray continues [m]: larger than the rounding of floats up to the hit.
float aside(const Vector3f& from, float distance) {
  return std::max(2e-4F, 4e-6F * (from.cwiseAbs().maxCoeff() + distance));
}

std::uint8_t toByte(float part) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(part, 0.0F, 1.0F)));
}

/// Copies values to a buffer of Embree, which is a little longer than its content.
template <class Value>
void fill(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<Value>& values) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Value), values.size());
  if (buffer == nullptr) {
    throw std::bad_alloc();
  }
  std::copy(values.begin(), values.end(), static_cast<Value*>(buffer));
}

}  // namespace

class RayTracer::Scene {
 public:
  Scene() : device_(rtcNewDevice(nullptr)) {
    if (device_ == nullptr) {
      throw std::runtime_error("Embree cannot be started, error " + std::to_string(rtcGetDeviceError(nullptr)));
    }
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);  // unchanged parts are not rebuilt
    rtcCommitScene(scene_);
  }
  ~Scene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void set(Part part, Geometry geometry) {
    const std::size_t first = kKinds.size() * static_cast<std::size_t>(part);
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
      detach(first + kind);
    }
    if (!geometry.triangles.empty()) {
      attach(first, std::move(geometry.triangle_tints), [&](RTCGeometry made) {
        fill(made, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, geometry.corners);
        fill(made, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, geometry.triangles);
      });
    }
    if (!geometry.balls.empty()) {
      attach(first + 1, std::move(geometry.ball_tints),
             [&](RTCGeometry made) { fill(made, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, geometry.balls); });
    }
    if (!geometry.rods.empty()) {
      std::vector<std::uint32_t> firsts(geometry.rod_tints.size());
      for (std::size_t rod = 0; rod < firsts.size(); ++rod) {
        firsts[rod] = static_cast<std::uint32_t>(2 * rod);
      }
      attach(first + 2, std::move(geometry.rod_tints), [&](RTCGeometry made) {
        fill(made, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, geometry.rods);
        fill(made, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, firsts);
      });
    }
    rtcCommitScene(scene_);
  }

  /// Colour seen along a ray. @param direction of length 1
  Vector3f look(const Vector3f& from, const Vector3f& direction, bool has_shadows) const {
    Vector3f seen = Vector3f::Zero();
    float left = 1.0F;
    float nearest = 0.0F;
    for (int layer = 0; layer < kMostLayers && left > kLeast; ++layer) {
      const Hit hit = meet(from, direction, nearest);
      if (!hit.isOne()) {
        break;
      }
      const float alpha = hit.tint.w();
      const Vector3f at = from + hit.distance * direction;
      const float beyond = aside(from, hit.distance);
      seen += left * alpha * light(at + beyond * hit.normal, hit.normal, has_shadows) * hit.tint.head<3>();
      left *= 1.0F - alpha;
      nearest = hit.distance + beyond;
    }
    return left > kLeast ? Vector3f(seen + left * background()) : seen;
  }

 private:
  template <class Fill>
  void attach(std::size_t number, std::vector<Tint> tints, Fill fill_in) {
    RTCGeometry made = rtcNewGeometry(device_, kKinds[number % kKinds.size()]);
    fill_in(made);
    rtcCommitGeometry(made);
    rtcAttachGeometryByID(scene_, made, static_cast<unsigned>(number));
    rtcReleaseGeometry(made);  // the scene keeps a reference
    tints_[number] = std::move(tints);
  }

  void detach(std::size_t number) {
    if (!tints_[number].empty()) {
      rtcDetachGeometry(scene_, static_cast<unsigned>(number));
      tints_[number].clear();
    }
  }

  Hit meet(const Vector3f& from, const Vector3f& direction, float nearest) const {
    RTCRayHit ray{};
    ray.ray.org_x = from.x();
    ray.ray.org_y = from.y();
    ray.ray.org_z = from.z();
    ray.ray.dir_x = direction.x();
    ray.ray.dir_y = direction.y();
    ray.ray.dir_z = direction.z();
    ray.ray.tnear = nearest;
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect(scene_, ray);
    Hit hit;
    if (ray.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
      hit.distance = ray.ray.tfar;
      hit.is_rod = kKinds[ray.hit.geomID % kKinds.size()] == RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE;
      hit.normal = Vector3f(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z).normalized();
      if (hit.normal.dot(direction) > 0.0F) {
        hit.normal = -hit.normal;
      }
      hit.tint = tints_[ray.hit.geomID][ray.hit.primID];
    }
    return hit;
  }

  /// Visible fraction of the colour of a surface. @param at point just in front of it
  float light(const Vector3f& at, const Vector3f& normal, bool has_shadows) const {
    const float slope = normal.dot(sun());
    if (slope <= 0.0F) {
      return kAmbient;
    }
    return kAmbient + (1.0F - kAmbient) * slope * (has_shadows ? sunlight(at) : 1.0F);
  }

  /// Fraction of the sun's light that reaches a point.
  float sunlight(const Vector3f& at) const {
    float left = 1.0F;
    float nearest = 0.0F;
    for (int layer = 0; layer < kMostLayers && left > kLeast; ++layer) {
      const Hit hit = meet(at, sun(), nearest);
      if (!hit.isOne()) {
        return left;
      }
      left *= hit.is_rod ? 1.0F : 1.0F - hit.tint.w();
      nearest = hit.distance + aside(at, hit.distance);
    }
    return left;
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::array<std::vector<Tint>, 2 * kKinds.size()> tints_;  // by geometry number
};

RayTracer::RayTracer(int threads) : scene_(std::make_unique<Scene>()), threads_(threads) {}
RayTracer::~RayTracer() = default;

void RayTracer::set(Part part, Geometry geometry) { scene_->set(part, std::move(geometry)); }

Vector3f RayTracer::sun() {
  static const Vector3f direction = Vector3f(-0.4F, -0.55F, 1.0F).normalized();
  return direction;
}

Vector3f RayTracer::background() { return {0.91F, 0.94F, 0.97F}; }

Picture RayTracer::render(const Camera& camera, int width, int height, const Options& options) const {
  const CameraAxes axes = axesOf(camera);
  const double pixel = 2.0 * std::tan(0.5 * camera.field_of_view) / width;  // at distance 1
  const int samples = options.samples;
  Picture picture{width, height, {}};
  picture.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto renderRow = [&](int row) {
    std::uint8_t* byte = &picture.rgb[3 * static_cast<std::size_t>(row) * static_cast<std::size_t>(width)];
    for (int column = 0; column < width; ++column) {
      Vector3f sum = Vector3f::Zero();
      for (int sample = 0; sample < samples * samples; ++sample) {
        const double right = (column + (sample % samples + 0.5) / samples - 0.5 * width) * pixel;
        const double up = (0.5 * height - row - (sample / samples + 0.5) / samples) * pixel;
        const Vector3d direction = (axes.forward + right * axes.right + up * axes.up).normalized();
        sum += scene_->look(camera.position.cast<float>(), direction.cast<float>(), options.has_shadows);
      }
      sum /= static_cast<float>(samples * samples);
      for (int channel = 0; channel < 3; ++channel) {
        *byte++ = toByte(sum[channel]);
      }
    }
  };
  tbb::task_arena(threads_).execute([&] { tbb::parallel_for(0, height, renderRow); });
  return picture;
}

}  // namespace swarmanoid
