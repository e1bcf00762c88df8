#pragma once
/// Which products of a method a picture needs.

#include <cstdint>

#include "picture/requests.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// The method for a request: the requested one; else, for fills, hatching and shadows, the first that returns regions;
/// else the default method, which method_choice.hpp may replace by another one.
const Method& method_of(const PictureRequest& request);

/// Whether the request has fills, hatching, shadows or PictureRequest::regions.
bool asks_for_regions(const PictureRequest& request);

/// Whether the picture hatches regions: if the method returns any. Otherwise it hatches spans.
bool hatches_regions(const PictureRequest& request, const Method& method);

/// Whether fills are painted from back to front: if the method returns an order and no light casts shadows.
bool paints_in_order(const PictureRequest& request, const Method& method);

/// Whether fills are made of the spans or pixels of a method that returns neither regions nor an order. No light casts
/// shadows then.
bool fills_spans(const PictureRequest& request, const Method& method);

/// The products that the picture needs, as bits of Product. A JSON drawing needs all products except pixels.
std::uint8_t wanted_products(const PictureRequest& request, const Method& method);

/// Whether the picture needs regions of its method.
bool wants_regions(const PictureRequest& request, const Method& method);

}  // namespace ligne
