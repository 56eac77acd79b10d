#pragma once
/// contacts.h5: place and force of contacts, one row per contact and step. Layout: docs/reference/outputs.md.
#include <chrono>
#include <filesystem>
#include <optional>

#include "core/base/state.h"
#include "core/hdf5/hdf5_columns.h"
#include "core/output/tables/contact_rows.h"
#include "core/scene/scene.h"

namespace nilas::output {

/// Writes contacts.h5. Steps are written at most a second after they were made, or when many rows are waiting.
class ContactsH5 {
 public:
  /// Whether the scene asks for the file: for contacts of the vessel and of structures, where there are any, or of all
  /// bodies. Never with integrator "reference".
  static bool asked(const scene::Scene& scene, const sim::RunInfo& info);

  /// Opens the file. `from`: the result of save(), to which the file is cut. Throws FileError, InputError.
  ContactsH5(const std::filesystem::path& path, const scene::Scene& scene, const sim::RunInfo& info,
             const StateReader* from);
  /// Writes pending rows if possible, for a run that ends with an error.
  ~ContactsH5();
  ContactsH5(const ContactsH5&) = delete;
  ContactsH5& operator=(const ContactsH5&) = delete;

  /// Throws FileError.
  void step(const sim::StepRecord& record, const std::vector<contact::SolvedProblem>& parts,
            const LoadedBodies& loaded);
  /// Returns when all steps are on the disk. Throws FileError.
  void sync();
  /// Throws FileError.
  void finish() { write(); }
  void save(StateWriter out) const;

 private:
  void add(const ContactRow& row, const sim::StepRecord& record);
  void write();

  bool of_all_bodies_, has_vessel_, has_couples_;
  hdf5::Hdf5Columns columns_;
  std::chrono::steady_clock::time_point written_;
};

}  // namespace nilas::output
