#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/view/take_pictures.h"
#include "apps/view/page.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/output/file/output_file.h"
#include "core/output/replay/piece.h"
#include "core/output/run/run_folder.h"
#include "core/output/text/console.h"

namespace nilas::commands {

namespace {

struct ViewOptions {
  std::string run, out;
  PictureOptions pictures;
};

/// The bytes of a run's replay. Throws FileError, InputError.
std::string replay_of(const std::filesystem::path& run) {
  demand_there(run, "run folder");
  if (!is_folder(run))
    throw InputError(run.string() + ": is a file; allowed: the folder of a run, in which replay.bin lies");
  const std::filesystem::path file = output::RunFolder::replay_file(run);
  if (!std::filesystem::exists(file)) {
    if (!std::filesystem::exists(output::RunFolder::scene_file(run)))
      throw InputError(run.string() + ": is no run folder, since it has no scene.xml");
    throw InputError(file.string() +
                     ": is missing. The run stored no frames, or it is of an older version of the program; run the "
                     "scene again with <output trajectory_every> above 0");
  }
  return file_bytes(file);
}

std::string scene_of(const output::replay::PieceView& head, const std::filesystem::path& run) {
  try {
    return nlohmann::json::parse(output::replay::unpacked(head.packed)).at("scene").get<std::string>();
  } catch (const nlohmann::json::exception&) {
    throw InputError(output::RunFolder::replay_file(run).string() + ": its head is damaged");
  } catch (const InputError& fault) {
    throw InputError(output::RunFolder::replay_file(run).string() + ": " + fault.what());
  }
}

/// The name of the scene, with that of the folder.
std::string title_of(const output::replay::PieceList& list, const std::filesystem::path& run) {
  std::string scene;
  for (const auto& piece : list.pieces)
    if (piece.kind == output::replay::k_head) scene = scene_of(piece, run);
  const std::filesystem::path folder = std::filesystem::absolute(run).lexically_normal();
  return scene + " (" + (folder.has_filename() ? folder.filename() : folder.parent_path().filename()).string() + ")";
}

/// What a replay lacks at its end, as a sentence; empty where it has all.
std::string lack_of(const output::replay::PieceList& list) {
  if (list.cut > 0) return "The last frame is incomplete and left out: the run was stopped while it wrote.";
  if (list.pieces.back().kind == output::replay::k_end) return "";
  return "The replay does not say how the run ended: the run still goes on, or it was killed.";
}

void write_page(const ViewOptions& options, const std::string& page, long frames) {
  const std::filesystem::path run = options.run;
  const std::filesystem::path out = options.out.empty() ? run / "replay.html" : std::filesystem::path(options.out);
  output::write_whole(out, page);
  constexpr double k_megabyte = 1e6;
  std::cout << fmt::format("{} frames, {:.1f} MB\n", frames, static_cast<double>(page.size()) / k_megabyte)
            << "written: " << out.string() << "\n"
            << "Open it in a browser; it needs no other file and no network.\n";
}

int show_run(const ViewOptions& options) {
  view::demand_page();
  check_picture_options(options.pictures, options.out);
  const std::filesystem::path run = options.run;
  const std::string bytes = replay_of(run);
  const auto list = output::replay::pieces_of(bytes, output::RunFolder::replay_file(run).string());
  const auto frames = std::count_if(list.pieces.begin(), list.pieces.end(),
                                    [](const auto& piece) { return piece.kind == output::replay::k_frame; });
  if (frames == 0) throw InputError(output::RunFolder::replay_file(run).string() + ": holds no frame yet");
  const std::string page = view::replay_page(title_of(list, run), bytes);
  if (options.pictures.wants_stills() || options.pictures.wants_film())
    take_pictures(options.pictures, page, run, options.out);
  else
    write_page(options, page, frames);
  if (const std::string lack = lack_of(list); !lack.empty()) std::cout << output::wrapped(lack, 0) << "\n";
  return exit_done;
}

}  // namespace

void add_view(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "view", "Writes a page that shows a run in 3-D, for any browser, or pictures and films of it.");
  auto options = std::make_shared<ViewOptions>();
  command->add_option("run", options->run, "Shows the run in this folder, which may still be going on.")->required();
  command->add_option(
      "--out", options->out,
      "Writes to this file. The default is replay.html in the folder for the page, view-<time>s.png for a "
      "picture, and view.mp4 for a film. Several pictures have their times in their names.");
  add_picture_options(*command, options->pictures);
  command->callback([&action, options] { action = [options] { return show_run(*options); }; });
}

}  // namespace nilas::commands
