#pragma once
/// Selects the method of a picture, and the products that it needs from the method.

#include <cstdint>

#include "picture/requests.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// The method for a request: the requested method; for fills, hatching and shadows the first one that returns regions;
/// otherwise the default method, which method_choice.hpp may replace.
const Method& method_of(const PictureRequest& request);

/// Whether the request has fills, hatching, shadows or PictureRequest::regions.
bool needs_regions(const PictureRequest& request);

/// Whether areas of faces have the colours of their materials, or the tones of these.
bool shows_materials(const PictureRequest& request);

/// Whether the picture hatches regions, which it does if the method returns regions. Otherwise it hatches spans.
bool hatches_regions(const PictureRequest& request, const Method& method);

/// Whether fills are painted from back to front. They are if the method returns an order and no light casts shadows.
bool paints_in_order(const PictureRequest& request, const Method& method);

/// Whether lit colours are continuous over smooth surfaces, as an image. The method must return spans or pixels.
bool fills_smoothly(const PictureRequest& request);

/// Whether fills are areas made of spans or pixels. They are if the method returns neither regions nor an order, and no
/// light casts shadows.
bool fills_spans(const PictureRequest& request, const Method& method);

/// Whether spans or pixels are painted, gray or in colour.
bool shows_faces_of_spans(const PictureRequest& request, const Method& method);

/// The products that the picture needs, as bits of Product. A JSON drawing needs all products except pixels.
std::uint8_t wanted_products(const PictureRequest& request, const Method& method);

/// Whether the picture needs regions from its method.
bool wants_regions(const PictureRequest& request, const Method& method);

}  // namespace ligne
