#pragma once
/// Models that are drawn without being read into memory as a whole. See docs/streaming.md.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "picture/models/models.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/readers/triangle_file.hpp"
#include "visibility/common/occluded_cells.hpp"

namespace ligne {

/// Whether a model is streamed. Automatic: if it would take more than half of the memory.
enum class Streaming : std::uint8_t { automatic, on, off };
inline constexpr std::string_view kStreamingNames[] = {"auto", "on", "off"};

/// Adjustable: smaller models are not streamed. In their drawings the order of strokes also depends on hidden faces.
inline constexpr std::size_t kFewestStreamedFaces = std::size_t{1} << 17;

/// The part of a model that determines its picture.
struct StreamedModel {
  LoadedModels models;
  std::shared_ptr<const OccludedCells> blank;  ///< for PictureRequest::blank
};

/// Returns the reason why a picture needs the whole model, as a phrase; empty if a part is enough.
std::string why_not_streamed(const ModelRequest& model, const PictureRequest& picture);

/// Returns the file if the model is streamed, else nullptr. Throws RequestError if streaming is requested but not
/// possible.
std::unique_ptr<TriangleFile> file_to_stream(Streaming streaming, const ModelRequest& model, const PictureRequest& picture);

/// Reads the file, in several passes. The picture of the returned part, with `blank`, by method `appel`, equals that of
/// the whole model. Returns nothing and sets `why` if that can not be guaranteed: the model is small, a part of it is
/// out of view, or a face is not a triangle. Throws InputError.
std::optional<StreamedModel> stream_model(TriangleFile& file, const PictureRequest& picture, RunReport& run,
                                          std::string& why);

}  // namespace ligne
