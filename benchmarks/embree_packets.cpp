// SPDX-License-Identifier: MIT
#include "benchmarks/embree_packets.hpp"

namespace cigsim::benchmarks {
namespace {

constexpr int kLanes = 8, kColumns = 4, kRows = 2;

}  // namespace

void cast_packets(RTCScene scene, const RayFrame& frame, const FaceTable& table,
                  std::uint32_t* colours, std::uint16_t* numbers) {
  alignas(32) int valid[kLanes];
  alignas(32) RTCRayHit8 packet;
  for (int k = 0; k < kLanes; ++k) valid[k] = -1;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (int r = 0; r < frame.height; r += kRows)
    for (int c = 0; c < frame.width; c += kColumns) {
      for (int k = 0; k < kLanes; ++k) {
        const float column = static_cast<float>(c + k % kColumns);
        const float row = static_cast<float>(r + k / kColumns);
        packet.ray.org_x[k] = frame.eye[0];
        packet.ray.org_y[k] = frame.eye[1];
        packet.ray.org_z[k] = frame.eye[2];
        packet.ray.dir_x[k] = frame.corner[0] + column * frame.right[0] + row * frame.down[0];
        packet.ray.dir_y[k] = frame.corner[1] + column * frame.right[1] + row * frame.down[1];
        packet.ray.dir_z[k] = frame.corner[2] + column * frame.right[2] + row * frame.down[2];
        packet.ray.tnear[k] = 0;
        packet.ray.tfar[k] = 1e30f;
        packet.ray.time[k] = 0;
        packet.ray.mask[k] = ~0u;
        packet.ray.flags[k] = 0;
        packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.primID[k] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect8(valid, scene, &context, &packet);
      for (int k = 0; k < kLanes; ++k) {
        const unsigned entry = packet.hit.primID[k] + 1;  // an invalid number wraps round to 0
        const long at = static_cast<long>(r + k / kColumns) * frame.width + c + k % kColumns;
        colours[at] = table.colours[entry];
        numbers[at] = table.numbers[entry];
      }
    }
}

}  // namespace cigsim::benchmarks
