#pragma once
/// Single rays by Embree 3 or 4, which hand over the context of a query in different ways.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>

namespace ligne::check {

using RayContext = RTCRayQueryContext;

inline void init_context(RayContext& context) { rtcInitRayQueryContext(&context); }

inline void shoot(RTCScene scene, RayContext& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}

inline void shoot(RTCScene scene, RayContext& context, RTCRayHit& hit) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &hit, &arguments);
}

}  // namespace ligne::check
#else
#include <embree3/rtcore.h>

namespace ligne::check {

using RayContext = RTCIntersectContext;

inline void init_context(RayContext& context) { rtcInitIntersectContext(&context); }

inline void shoot(RTCScene scene, RayContext& context, RTCRay& ray) { rtcOccluded1(scene, &context, &ray); }

inline void shoot(RTCScene scene, RayContext& context, RTCRayHit& hit) { rtcIntersect1(scene, &context, &hit); }

}  // namespace ligne::check
#endif
