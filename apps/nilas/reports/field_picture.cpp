#include "apps/nilas/reports/field_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/output/text/plot.h"

namespace nilas::commands {

namespace {

constexpr double k_map_share = 0.68;  ///< width of the map as a share of the picture's width

struct Box {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  void add(const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

std::vector<Vec2> region_outline(const scene::FieldScene& field) {
  const scene::RegionScene& r = *field.region();
  return {{r[0], r[1]}, {r[2], r[1]}, {r[2], r[3]}, {r[0], r[3]}};
}

bool has_region(const sim::PlannedIce& ice) { return ice.field && ice.field->region() != nullptr; }

Box box_of(const std::vector<sim::PlannedIce>& ice) {
  Box box;
  for (const auto& group : ice) {
    for (const auto& one : group.floes)
      for (const Vec2& p : one.floe.outline) box.add(p);
    for (const auto& outline : group.keep_out)
      for (const Vec2& p : outline) box.add(p);
    if (has_region(group))
      for (const Vec2& p : region_outline(*group.field)) box.add(p);
  }
  const Vec2 margin = Vec2::Constant(0.02 * (box.high - box.low).maxCoeff());
  return {box.low - margin, box.high + margin};
}

void add_ring(std::string& data, const std::vector<Vec2>& outline, double value) {
  for (std::size_t k = 0; k <= outline.size(); ++k) {
    const Vec2& p = outline[k % outline.size()];
    data += fmt::format("{:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), value);
  }
  data += "\n";
}

void add_line(std::string& data, const std::vector<Vec2>& points) {
  for (const Vec2& p : points) data += fmt::format("{:.9g} {:.9g} 0\n", p.x(), p.y());
  data += "\n";
}

/// The outlines as data blocks for gnuplot.
std::string data_of(const std::vector<sim::PlannedIce>& ice) {
  std::string floes, weak, hull, keep_out, regions;
  for (const auto& group : ice) {
    for (const auto& one : group.floes) add_ring(floes, one.floe.outline, one.floe.thickness);
    for (const auto& line : group.weak_lines) add_line(weak, line.points);
    for (const auto& outline : group.hull) add_ring(hull, outline, 0);
    for (const auto& outline : group.keep_out) add_ring(keep_out, outline, 0);
    if (has_region(group)) add_ring(regions, region_outline(*group.field), 0);
  }
  // gnuplot takes no empty block
  const auto block = [](const char* name, const std::string& lines) {
    return fmt::format("${} << EOD\n{}EOD\n", name, lines.empty() ? "NaN NaN NaN\n" : lines);
  };
  return block("floes", floes) + block("weak", weak) + block("hull", hull) + block("keep_out", keep_out) +
         block("regions", regions);
}

bool thickness_varies(const std::vector<sim::PlannedIce>& ice) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const auto& group : ice)
    for (const auto& one : group.floes) {
      least = std::min(least, one.floe.thickness);
      most = std::max(most, one.floe.thickness);
    }
  return most > least;
}

std::string map_script(const std::string& title, const std::vector<sim::PlannedIce>& ice) {
  const Box box = box_of(ice);
  const bool coloured = thickness_varies(ice);
  std::string script = fmt::format(
      "set lmargin at screen 0.06\nset rmargin at screen {}\nset tmargin at screen 0.93\nset bmargin at screen 0.13\n"
      "set size ratio -1\nset xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\nset xlabel 'x [m]'\nset ylabel 'y "
      "[m]'\nset title '{}' noenhanced\nset style fill solid 1 border lc rgb '#40566b'\n"
      "set palette defined (0 '#f3f8fc', 0.5 '#8fbad9', 1 '#1f4e79')\nset cblabel 'thickness [m]'\n"
      "set key off\n",
      k_map_share - (coloured ? 0.11 : 0.02), box.low.x(), box.high.x(), box.low.y(), box.high.y(), title);
  script += fmt::format(
      "plot $floes using 1:2{} with filledcurves closed {}, \\\n"
      "  $weak using 1:2 with lines lw 1 lc rgb '#7090a8', \\\n"
      "  $regions using 1:2 with lines lw 1.5 dt 2 lc rgb '#808080', \\\n"
      "  $keep_out using 1:2 with lines lw 1.5 dt 3 lc rgb '#c04000', \\\n"
      "  $hull using 1:2 with lines lw 2 lc rgb '#c04000'\n",
      coloured ? ":3" : "", coloured ? "fc palette" : "fc rgb '#b9d5ea'");
  return script;
}

/// The edges of the bars of a histogram [m].
std::vector<double> bins_of(const QuantityReport& sizes) {
  const field::DistributionSummary obtained = field::summary_of(sizes.floes);
  double low = obtained.min, high = obtained.max;
  if (sizes.asked) {
    low = std::min(low, sizes.asked(0));
    high = std::max(high, sizes.asked(1));
  }
  constexpr double k_equal = 1e-6;  // sizes that differ less count as one size
  const double spare = high > (1 + k_equal) * low ? 0 : 0.5 * low;
  constexpr double k_fewest = 5, k_most = 41;
  // odd, so that a single size lies inside a bar
  const double count =
      std::clamp(2 * std::round(0.5 * std::sqrt(static_cast<double>(sizes.floes.size()))) + 1, k_fewest, k_most);
  // the ends of the range lie inside the outer bars, not on their edges
  const double width = (high - low + 2 * spare) / (count - 0.5);
  std::vector<double> edges;
  for (int k = 0; k <= static_cast<int>(count); ++k) edges.push_back(low - spare + width * (k - 0.25));
  return edges;
}

std::string histogram_script(const FieldReport& report, double bottom, double top) {
  const QuantityReport& sizes = report.quantities.front();
  const auto edges = bins_of(sizes);
  const auto n = static_cast<double>(sizes.floes.size());
  std::string lines;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const auto count = std::count_if(sizes.floes.begin(), sizes.floes.end(),
                                     [&](double x) { return x > edges[k] && x <= edges[k + 1]; });
    const double asked = sizes.asked ? n * (field::probability_up_to(sizes.asked, edges[k + 1]) -
                                            field::probability_up_to(sizes.asked, edges[k]))
                                     : 0;
    lines += fmt::format("{:.9g} {:.9g} {} {:.9g}\n", 0.5 * (edges[k] + edges[k + 1]), edges[k + 1] - edges[k], count,
                         asked);
  }
  std::string script = fmt::format(
      "$bars << EOD\n{}EOD\nset size noratio\nunset colorbox\nset lmargin at screen {}\nset rmargin at screen 0.98\n"
      "set tmargin at screen {}\nset bmargin at screen {}\nset xrange [{:.9g}:{:.9g}]\nset yrange [0:*]\n"
      "set xlabel 'size, square root of the area [m]'\nset ylabel 'floes' offset 1.5\n"
      "set title '{}: {} floes' noenhanced\nset key top right noenhanced\n"
      "set style fill solid 1 border lc rgb '#40566b'\nplot $bars using 1:3:2 with boxes fc rgb '#b9d5ea' "
      "title 'obtained'",
      lines, k_map_share + 0.07, top, bottom, edges.front(), edges.back(), report.name, report.floes);
  if (sizes.asked) script += ", $bars using 1:4 with histeps lw 2 lc rgb '#c04000' title 'asked'";
  return script + "\n";
}

}  // namespace

int picture_height(const std::vector<sim::PlannedIce>& ice, const std::vector<FieldReport>& reports) {
  constexpr int k_least = 560, k_most = 1700, k_per_histogram = 300;
  constexpr double k_map_width = (k_map_share - 0.17) * k_picture_width, k_used = 0.8;
  const Box box = box_of(ice);
  const Vec2 side = box.high - box.low;
  const int for_map = static_cast<int>(std::min<double>(k_most, k_map_width * side.y() / side.x() / k_used));
  return std::max({k_least, for_map, k_per_histogram * static_cast<int>(reports.size())});
}

void draw_field(const std::filesystem::path& file, const std::string& title, const std::vector<sim::PlannedIce>& ice,
                const std::vector<FieldReport>& reports) {
  std::string name = file.filename().string();
  for (auto quote = name.find('\''); quote != std::string::npos; quote = name.find('\'', quote + 2))
    name.insert(quote, 1, '\'');
  std::string script = data_of(ice);
  script += fmt::format("set terminal pngcairo size {},{} font 'sans,13'\nset output '{}'\nset multiplot\n",
                        k_picture_width, picture_height(ice, reports), name);
  script += map_script(title, ice);
  const auto panels = static_cast<double>(reports.size());
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const double top = 1 - static_cast<double>(k) / panels, bottom = 1 - static_cast<double>(k + 1) / panels;
    const double height = top - bottom;
    script += histogram_script(reports[k], bottom + 0.2 * height, top - 0.1 * height);
  }
  script += "unset multiplot\n";
  output::plot(file.parent_path().empty() ? std::filesystem::path(".") : file.parent_path(), script);
}

}  // namespace nilas::commands
