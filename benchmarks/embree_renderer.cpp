// SPDX-License-Identifier: MIT
#include "benchmarks/embree_renderer.hpp"

#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <stdexcept>

#include "benchmarks/embree_packets.hpp"

namespace cigsim::benchmarks {
namespace {

void store(float (&out)[3], const Vec3& v) {
  out[0] = static_cast<float>(v.x);
  out[1] = static_cast<float>(v.y);
  out[2] = static_cast<float>(v.z);
}

RayFrame ray_frame(const ViewTransform& view) {
  const Vec3 u = view.rotation.row[0], v = view.rotation.row[1], w = view.rotation.row[2];
  const double column = (0.5 - view.raster.width / 2.0) / view.focal;
  const double row = (view.raster.height / 2.0 - 0.5) / view.focal;
  RayFrame frame;
  store(frame.eye, view.eye);
  store(frame.corner, u + v * column + w * row);
  store(frame.right, v * (1 / view.focal));
  store(frame.down, w * (-1 / view.focal));
  frame.width = view.raster.width;
  frame.height = view.raster.height;
  return frame;
}

}  // namespace

class EmbreeRenderer::Impl {
 public:
  Impl(const Mesh& mesh, const Raster& raster)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    picture_.width = raster.width;
    picture_.height = raster.height;
    picture_.colours.resize(static_cast<std::size_t>(raster.width) * raster.height);
    picture_.numbers.resize(picture_.colours.size());
    colours_.push_back(mesh.background);
    colours_.insert(colours_.end(), mesh.colours.begin(), mesh.colours.end());
    numbers_.push_back(0);
    numbers_.insert(numbers_.end(), mesh.numbers.begin(), mesh.numbers.end());
    load(mesh);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
      throw std::runtime_error("Embree did not build the scene");
  }
  ~Impl() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  const Picture& draw(const ViewTransform& view) {
    // Embree's manual asks for flushed denormals.
    const unsigned control = _mm_getcsr();
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    cast_packets(scene_, ray_frame(view), {colours_.data(), numbers_.data()},
                 picture_.colours.data(), picture_.numbers.data());
    _mm_setcsr(control);
    return picture_;
  }

  std::string description() const {
    const bool native = rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED);
    return std::string("Embree ") + RTC_VERSION_STRING +
           (native ? ", native packets of 8" : ", packets of 8 not native");
  }

 private:
  void load(const Mesh& mesh) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_QUAD);
    void* const vertices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.positions.size() / 3);
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<float*>(vertices));
    unsigned* const indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), mesh.faces()));
    for (unsigned k = 0; k < 4 * mesh.faces(); ++k) indices[k] = k;
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_NONE);
    rtcCommitScene(scene_);
  }

  RTCDevice device_;
  RTCScene scene_;
  std::vector<std::uint32_t> colours_;
  std::vector<std::uint16_t> numbers_;
  Picture picture_;
};

bool EmbreeRenderer::available() { return __builtin_cpu_supports("avx2"); }

EmbreeRenderer::EmbreeRenderer(const Mesh& mesh, const Raster& raster)
    : impl_(std::make_unique<Impl>(mesh, raster)) {}
EmbreeRenderer::~EmbreeRenderer() = default;

const Picture& EmbreeRenderer::draw(const ViewTransform& view) { return impl_->draw(view); }
std::string EmbreeRenderer::description() const { return impl_->description(); }

}  // namespace cigsim::benchmarks
