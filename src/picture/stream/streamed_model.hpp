#pragma once
/// Models that are drawn without being in memory as a whole. See docs/streaming.md.

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

/// Whether a model is streamed; automatic: where it would take more than half of the memory.
enum class Streaming : std::uint8_t { automatic, on, off };
inline constexpr std::string_view kStreamingNames[] = {"auto", "on", "off"};

/// Adjustable: smaller models are not streamed. In their drawings the order of strokes also depends on what is hidden.
inline constexpr std::size_t kFewestStreamedFaces = std::size_t{1} << 17;

/// The part of a model that a picture is made of.
struct StreamedModel {
  LoadedModels models;
  std::shared_ptr<const OccludedCells> blank;  ///< for PictureRequest::blank
};

/// Why a picture can not be made of a part of the model, as a phrase; empty when it can.
std::string why_not_streamed(const ModelRequest& model, const PictureRequest& picture);

/// The file where the model is to be streamed, else nullptr. Throws RequestError where that is asked for and can not be.
std::unique_ptr<TriangleFile> file_to_stream(Streaming streaming, const ModelRequest& model, const PictureRequest& picture);

/// Reads the file, several times. The picture of what is left, with `blank`, by method `appel`, is that of the whole model.
/// Nothing where that is not so, because it is small, part of it is out of view, or a face is no triangle; `why` says which.
/// Throws InputError.
std::optional<StreamedModel> stream_model(TriangleFile& file, const PictureRequest& picture, RunReport& run,
                                          std::string& why);

}  // namespace ligne
