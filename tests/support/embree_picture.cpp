// SPDX-License-Identifier: MIT
#include "tests/support/embree_picture.hpp"

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "models/numeric/plane.hpp"

namespace cigsim::test {
namespace {

template <auto release>
struct Releaser {
  template <class T>
  void operator()(T* handle) const {
    release(handle);
  }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Releaser<rtcReleaseDevice>>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Releaser<rtcReleaseScene>>;

bool looks_away(const OraclePolygon& polygon, const Vec3& eye) {
  for (std::size_t i = 2; i < polygon.vertices.size(); ++i) {
    const int s =
        orientation(polygon.vertices[0], polygon.vertices[i - 1], polygon.vertices[i], eye);
    if (s != 0) return s < 0;
  }
  return true;
}

void attach(RTCDevice device, RTCScene scene, const OraclePolygon& polygon, std::uint32_t id,
            const Vec3& eye) {
  const std::size_t n = polygon.vertices.size();
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), n));
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), n - 2));
  for (const Vec3& v : polygon.vertices) {
    const Vec3 d = v - eye;
    for (const double c : {d.x, d.y, d.z}) *vertex++ = static_cast<float>(c);
  }
  for (unsigned i = 2; i < n; ++i)
    for (const unsigned k : {0u, i - 1, i}) *index++ = k;
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

}  // namespace

std::vector<EmbreeHit> cast_with_embree(const std::vector<OraclePolygon>& polygons,
                                        const ViewTransform& view) {
  const Device device(rtcNewDevice("threads=1"));
  if (!device) throw std::runtime_error("Embree gives no device");
  const Scene scene(rtcNewScene(device.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  for (std::uint32_t p = 0; p < polygons.size(); ++p)
    if (polygons[p].two_sided || !looks_away(polygons[p], view.eye))
      attach(device.get(), scene.get(), polygons[p], p, view.eye);
  rtcCommitScene(scene.get());
  if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot build the scene");

  std::vector<EmbreeHit> picture;
  for (int r = 0; r < view.raster.height; ++r)
    for (int c = 0; c < view.raster.width; ++c) {
      const double x = (c + 0.5 - view.raster.width / 2.0) / view.focal;
      const double y = (r + 0.5 - view.raster.height / 2.0) / view.focal;
      const Vec3 d = view.rotation.row[0] + view.rotation.row[1] * x - view.rotation.row[2] * y;
      RTCRayHit ray{};
      ray.ray.dir_x = static_cast<float>(d.x);
      ray.ray.dir_y = static_cast<float>(d.y);
      ray.ray.dir_z = static_cast<float>(d.z);
      ray.ray.tfar = std::numeric_limits<float>::infinity();
      ray.ray.mask = ~0u;
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcIntersect1(scene.get(), &context, &ray);
      const bool hit = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
      picture.push_back({hit ? ray.hit.geomID : kNone, hit ? ray.ray.tfar : 0});
    }
  return picture;
}

}  // namespace cigsim::test
