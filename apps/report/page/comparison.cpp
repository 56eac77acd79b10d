#include "apps/report/page/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/figures/exceedance.h"
#include "apps/report/page/ice_section.h"
#include "apps/report/page/load_sections.h"
#include "apps/report/page/words.h"
#include "apps/report/run/scene_difference.h"

namespace nilas::report {

namespace {

using Runs = std::vector<std::unique_ptr<RunFindings>>;

/// A mean less that of the first run, with the error of the difference of two runs that are independent.
struct MeanDifference {
  double value = 0;
  std::optional<double> error;
  bool is_told = false;   ///< larger than its error
  bool at_least = false;  ///< the error is a lower bound
};

MeanDifference difference_of(const BodyLoad& load, const BodyLoad& first) {
  MeanDifference difference;
  difference.value = load.along.statistics.mean - first.along.statistics.mean;
  if (!load.along.half_width || !first.along.half_width) return difference;
  difference.error = std::hypot(*load.along.half_width, *first.along.half_width);
  difference.at_least = load.error_at_least || first.error_at_least;
  difference.is_told = std::abs(difference.value) > *difference.error;
  return difference;
}

/// The names of the runs, those of equal folders with their paths.
std::vector<std::string> names_of(const Runs& runs) {
  std::vector<std::string> names;
  for (const auto& run : runs) {
    const auto same =
        std::count_if(runs.begin(), runs.end(), [&](const auto& r) { return r->run.name == run->run.name; });
    names.push_back(same > 1 ? run->run.folder.string() : run->run.name);
  }
  return names;
}

/// A doubt where the vessels are of different scales; empty where they are not.
std::string scale_doubt(const Runs& runs, const std::vector<std::string>& names) {
  constexpr double k_other_scale = 1.5;
  const auto length = [&](std::size_t k) {
    return runs[k]->shapes && runs[k]->load != nullptr && runs[k]->load->is_vessel()
               ? runs[k]->shapes->info.vessel_length
               : 0.0;
  };
  std::size_t least = runs.size(), most = runs.size();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (!(length(k) > 0)) continue;
    if (least == runs.size() || length(k) < length(least)) least = k;
    if (most == runs.size() || length(k) > length(most)) most = k;
  }
  if (least == runs.size() || length(most) < k_other_scale * length(least)) return "";
  return fmt::format(
      "The vessel of {} is {:.4g} m long and that of {} {:.4g} m. These runs are of different scales, so their loads "
      "do not compare as they are. By Froude's law a force grows with the cube of the length, which is {:.4g} times "
      "here.",
      names[least], length(least), names[most], length(most), std::pow(length(most) / length(least), 3));
}

/// The attributes in which the scenes differ; nothing where one of them cannot be read.
std::optional<std::vector<SceneDifference>> differences_of(const Runs& runs) {
  std::vector<std::string> scenes;
  for (const auto& run : runs) {
    if (!run->run.scene) return std::nullopt;
    scenes.push_back(run->run.scene->as_run);
  }
  return scene_differences(scenes);
}

/// A doubt where the scenes differ in more than one attribute; empty where they do not differ.
std::string scene_doubt(const Runs& runs) {
  constexpr std::size_t k_named = 5;
  const auto differences = differences_of(runs);
  if (!differences) return "Not every scene can be read, so it is not known in what these runs differ.";
  const std::size_t count = differences->size();
  if (count == 0) return "";
  if (count == 1) return fmt::format("The scenes differ in {} alone.", differences->front().path);
  std::string names;
  for (std::size_t k = 0; k < std::min(count, k_named); ++k)
    names += (k == 0 ? "" : k + 1 == count ? " and " : ", ") + (*differences)[k].path;
  if (count <= k_named)
    return fmt::format("The scenes differ in {}. A difference of loads may come from any of these.", names);
  return fmt::format(
      "The scenes are unlike: they differ in {} attributes, the first of them {}. A difference of their loads has no "
      "one "
      "cause.",
      count, names);
}

/// What the errors of means and differences leave out.
std::string other_ice(const Runs& runs) {
  const bool has_load = std::any_of(runs.begin(), runs.end(), [](const auto& run) { return run->load != nullptr; });
  if (!has_load) return "";
  return "No error here covers other ice of the same kind: another seed can change a mean by more than its error. Run "
         "several seeds (--seed) of each before you trust a difference.";
}

std::string first_sentence(const Runs& runs, const std::vector<std::string>& names) {
  const RunFindings& first = *runs.front();
  if (first.load == nullptr) return "The first run has nothing that bears a load, so loads are not compared.";
  std::string text = fmt::format(
      "The mean ice load on {} of {}, positive {}, is {}.", first.subject(), names.front(),
      sides_along(first.load->is_vessel()).positive,
      mean_with_error(first.load->along.statistics.mean, first.load->along.half_width, first.load->error_at_least));
  const auto warn = [&](std::size_t k) {
    if (runs[k]->load->is_unsteady())
      text += fmt::format(" The load of {} is not steady, so its error is too small.", names[k]);
  };
  warn(0);
  for (std::size_t k = 1; k < runs.size(); ++k) {
    if (runs[k]->load == nullptr) continue;
    warn(k);
    const MeanDifference difference = difference_of(*runs[k]->load, *first.load);
    const std::string least = difference.at_least ? "at least " : "";
    text += fmt::format(" The mean of {} is {} {}, {}.", names[k], output::force_text(std::abs(difference.value)),
                        difference.value < 0 ? "lower" : "higher",
                        !difference.error ? "with an error that is not known"
                        : difference.is_told
                            ? "more than its error of " + least + error_force(*difference.error, difference.value)
                            : "within its error of " + least + error_force(*difference.error, difference.value));
  }
  return text;
}

Section runs_section(const Runs& runs, const std::vector<std::string>& names) {
  Section section{.id = "runs", .title = "The runs"};
  section.text.emplace_back(
      "Loads along the course, positive astern, or along the drift, over each run's own window. The error of a "
      "difference is the root of the sum of squares "
      "of both errors. It holds for runs whose scatter is independent.");
  PageTable table{.head = {"", "mean", "less the first", "standard deviation", "99 % of steps below, by size",
                           "largest filtered", "largest of one step", "simulated", "wall time"}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const RunFindings& run = *runs[k];
    std::vector<std::string> row{names[k]};
    if (run.load == nullptr) {
      row.insert(row.end(), 6, "no load");
    } else {
      const output::ComponentLoad& load = run.load->along;
      row.push_back(mean_with_error(load.statistics.mean, load.half_width, run.load->error_at_least));
      const bool compared = k > 0 && runs.front()->load != nullptr;
      const MeanDifference difference = compared ? difference_of(*run.load, *runs.front()->load) : MeanDifference{};
      row.push_back(compared ? mean_with_error(difference.value, difference.error, difference.at_least) : "");
      for (const double value : {load.statistics.std, load.statistics.p99, load.peak.filtered, load.peak.raw})
        row.push_back(output::force_text(value));
    }
    row.push_back(fmt::format("{:.6g} s", run.run.times().back() - run.run.start()));
    row.push_back(run.run.summary.contains("wall_s") && run.run.summary.at("wall_s").is_number()
                      ? fmt::format("{:.4g} s", run.run.summary.at("wall_s").get<double>())
                      : "not known");
    table.rows.push_back(std::move(row));
  }
  section.tables.push_back(std::move(table));
  return section;
}

Section scenes_section(const Runs& runs, const std::vector<std::string>& names) {
  Section section{.id = "scenes", .title = "How the scenes differ"};
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (!runs[k]->run.scene)
      section.gaps.push_back("The scene of " + names[k] + " cannot be read, so scenes are not compared.");
  if (!section.gaps.empty()) return section;
  const std::vector<SceneDifference> differences = differences_of(runs).value();
  if (differences.empty()) {
    section.text.emplace_back("The scenes are the same but for what they store.");
    return section;
  }
  PageTable table{.head = {"attribute"}};
  table.head.insert(table.head.end(), names.begin(), names.end());
  for (const SceneDifference& difference : differences) {
    std::vector<std::string> row{difference.path};
    for (const std::string& value : difference.values) row.push_back(value.empty() ? "absent" : value);
    table.rows.push_back(std::move(row));
  }
  section.text.push_back(
      fmt::format("{} of the resolved scenes {}. What a run stores does not count.",
                  differences.size() == 1 ? "One attribute" : fmt::format("{} attributes", differences.size()),
                  differences.size() == 1 ? "differs" : "differ"));
  section.tables.push_back(std::move(table));
  return section;
}

/// The unit of the largest load of all runs.
output::ForceUnit common_unit(const Runs& runs) {
  double largest = 0;
  for (const auto& run : runs)
    if (run->load != nullptr) largest = std::max(largest, std::abs(run->load->along.peak.raw));
  return output::force_unit(largest);
}

Section curves_section(const Runs& runs, const std::vector<std::string>& names) {
  Section section{.id = "curves", .title = "Loads over each other"};
  const output::ForceUnit unit = common_unit(runs);
  const double factor = 1 / unit.size;
  // As in the report of one run, levels count in the direction of the mean: here that of the first run.
  const BodyLoad* first = runs.front()->load;
  const double side = first != nullptr && first->along.statistics.mean < 0 ? -1 : 1;
  const std::string force = fmt::format("load [{}]", unit.name);
  Plot loads{.id = "load-along",
             .title = first == nullptr || first->is_vessel() ? "Ice load along the course, positive astern"
                                                             : "Ice load along the drift",
             .x_label = "time [s]",
             .y_label = force,
             .over_time = true};
  Plot spectra{.id = "spectrum",
               .title = "Spectral density of the ice load along the course",
               .x_label = "frequency [Hz]",
               .y_label = fmt::format("density [{}²/Hz]", unit.name),
               .log_x = true,
               .log_y = true};
  Plot shares{.id = "exceedance",
              .title = "Share of steps whose load reaches a level",
              .x_label = side < 0 ? fmt::format("load, its sign turned [{}]", unit.name) : force,
              .y_label = "share of steps [%]",
              .log_y = true};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const RunFindings& run = *runs[k];
    if (run.load == nullptr) continue;
    loads.curves.push_back(along_curve(run, names[k], factor));
    if (auto curve = spectrum_curve(run.load->series, *run.load, run.run.step(), names[k], factor))
      spectra.curves.push_back(std::move(*curve));
    if (run.load->window.steps() <= 1) continue;
    std::vector<double> sided = run.load->window.of(run.load->series);
    for (double& value : sided) value *= side;
    shares.curves.push_back(step_exceedance(names[k], std::move(sided), factor));
  }
  if (loads.curves.empty()) section.gaps.emplace_back("No run has anything that bears a load.");
  for (Plot* plot : {&loads, &spectra, &shares})
    if (!plot->curves.empty()) section.plots.push_back(std::move(*plot));
  return section;
}

Section cover_section(const Runs& runs, const std::vector<std::string>& names) {
  Section section{.id = "ice", .title = "Ice ahead"};
  Plot plot{.id = "concentration",
            .title = "Ice concentration ahead",
            .x_label = "time [s]",
            .y_label = "covered [%]",
            .over_time = true};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    std::optional<Curve> curve;
    runs[k]->run.attempt("The ice ahead", [&] { curve = cover_curve(*runs[k], names[k]); });
    if (curve)
      plot.curves.push_back(std::move(*curve));
    else
      section.gaps.push_back("The ice ahead is not known of " + names[k] + ".");
  }
  if (!plot.curves.empty()) section.plots.push_back(std::move(plot));
  return section;
}

Section all_gaps(const Runs& runs, const std::vector<std::string>& names) {
  Section section{.id = "gaps", .title = "What is missing"};
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (const Gap& gap : runs[k]->run.gaps) section.gaps.push_back(names[k] + ": " + gap.what + ": " + gap.why);
  if (section.gaps.empty()) section.text.emplace_back("Nothing: every file that the report reads was there and whole.");
  return section;
}

}  // namespace

ReportPage comparison_page(const std::vector<std::unique_ptr<RunFindings>>& runs) {
  const std::vector<std::string> names = names_of(runs);
  ReportPage page;
  for (const std::string& name : names) page.title += (page.title.empty() ? "Comparison of " : ", ") + name;
  page.headline = {first_sentence(runs, names)};
  for (std::string text : {scale_doubt(runs, names), scene_doubt(runs), other_ice(runs)})
    if (!text.empty()) page.headline.push_back(std::move(text));
  page.sections = {runs_section(runs, names), scenes_section(runs, names), curves_section(runs, names),
                   cover_section(runs, names), all_gaps(runs, names)};
  return page;
}

}  // namespace nilas::report
