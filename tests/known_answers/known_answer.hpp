#pragma once
/// Scenes whose visible lines were worked out by hand, one JSON file each; README.md tells the format.

#include "linework/stroke.hpp"
#include "scene/model/scene.hpp"
#include "support/standard.hpp"
#include "view/view.hpp"

namespace ligne::test {

/// A piece of a line that is visible, or hidden, as a whole; in model coordinates.
struct KnownSegment {
  Point3 from{0, 0, 0}, to{0, 0, 0};
  LineClass line_class = LineClass::mesh;
  bool visible = true;
};

struct KnownAnswer {
  std::string name;                    ///< the file's name without its suffix
  std::string about;                   ///< one line
  std::vector<std::string> reasoning;  ///< lines of prose that derive every end
  Scene scene;
  CameraRequest camera;
  Point3 right{1, 0, 0}, down{0, 0, -1};  ///< directions of the page's axes in the model, of any length
  std::string edges;                      ///< "all", "feature", or names of classes
  bool with_hidden = false;               ///< the answer tells the hidden lines too
  std::vector<KnownSegment> segments;     ///< whatever the order; each line once
};

/// A fault of a file, in one line that begins with its name.
struct KnownAnswerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads one answer; a scene that is named by its path is looked for beside the file. Throws KnownAnswerError.
KnownAnswer read_known_answer(const std::filesystem::path& file);

/// All answers in a folder, by name.
std::vector<std::filesystem::path> known_answer_files(const std::filesystem::path& folder);

}  // namespace ligne::test
