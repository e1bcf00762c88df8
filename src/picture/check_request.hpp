#pragma once
/// Validation of requests.

#include "picture/requests.hpp"

namespace ligne {

/// Throws RequestError if parts of the request contradict each other or the method: grey faces or hatching in a format
/// that can not have them, hatching or fills with a method that does not return what they need, margins that leave no
/// page.
void check(const PictureRequest& request);

/// Gives a request for grey faces without a method one that makes spans.
void choose_method_of_gray_faces(PictureRequest& request);

/// Makes the method count the faces in front of lines if LineRequest::most_hiding needs it. Throws RequestError for a
/// method that does not count them.
void count_hidden(LineRequest& request);

}  // namespace ligne
