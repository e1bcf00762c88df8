#pragma once
/// Segments of the page, by the names of the tests.

#include "geometry/page_segments.hpp"

namespace ligne::test {

using paper::along;
using paper::common_length;
using paper::deviation;
using paper::gaps;
using paper::Range;
using paper::Segment;

}  // namespace ligne::test
