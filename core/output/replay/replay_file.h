#pragma once
/// replay.bin: the motion of a run in a compact form, for viewers. Layout: docs/reference/replay-file.md.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/bodies/drawn_line.h"
#include "core/output/file/output_file.h"
#include "core/output/replay/channels.h"
#include "core/output/replay/contact_writer.h"
#include "core/output/replay/contacts.h"
#include "core/output/replay/frame.h"
#include "core/output/replay/number_coder.h"
#include "core/output/replay/piece.h"
#include "core/output/vtk/trajectory.h"
#include "core/scene/scene.h"

namespace nilas::output::replay {

/// A step that a frame shows.
struct ShownState {
  double t = 0, h = 0;  ///< time and length of the step [s]
  long step = 0;
  const bodies::Bodies& bodies;
  const std::vector<contact::SolvedProblem>& substeps;
  const FloeDamage& damage;                     ///< empty: no floe is damaged
  const std::vector<bodies::DrawnLine>& lines;  ///< of the modules
};

class ReplayFile {
 public:
  /// Opens the file and writes its head. `keep`: as in OutputFile, with the state that save() gave then.
  /// Throws FileError, InputError.
  ReplayFile(const std::filesystem::path& path, const scene::Scene& scene, const sim::RunInfo& info,
             const std::vector<std::string>& vessel_names, bool has_contact_table,
             std::optional<std::int64_t> keep = {}, const StateReader* from = nullptr);
  /// Takes the channels of a step; called for every step, before its frame.
  void note(const sim::StepRecord& record, const std::vector<double>& vessel_values);
  /// Writes a frame. Throws FileError.
  void frame(const ShownState& shown);
  /// Writes how the run ended, as a sentence, and closes the file. Throws FileError.
  void finish(const std::string& reason);
  void save(StateWriter out) const;
  const OutputFile& file() const { return file_; }

 private:
  BodyMarks marks_of(const ShownState& shown, const FrameContacts& contacts, const LoadedBodies& loaded) const;
  void add_lines(const std::vector<bodies::DrawnLine>& lines, std::string& out) const;

  sim::RunInfo info_;
  bool has_contact_table_, of_all_bodies_, has_damage_;
  Channels channels_;
  BodyFrames frames_;
  ContactWriter contacts_;
  NumberCoder numbers_;
  std::vector<bodies::DrawnLine> arrows_;  ///< the loads of carriage and wind on the vessel in the newest step
  OutputFile file_;
  Content content_;
  std::string rest_;    ///< what follows the coded numbers of a frame
  std::string shapes_;  ///< of the pieces of a frame
};

}  // namespace nilas::output::replay
