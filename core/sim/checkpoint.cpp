#include "core/sim/checkpoint.h"

#include <set>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/hdf5/hdf5_file.h"

namespace nilas::sim {

namespace {

constexpr const char* k_format = "nilas checkpoint";
constexpr const char* k_group = "state/";

void add_text(const std::string& text, StateHash& hash) {
  hash.add(static_cast<std::uint64_t>(text.size()));
  for (const char c : text) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
}

void add_entry(const StateEntry& entry, StateHash& hash) {
  hash.add(static_cast<std::uint64_t>(entry.index()));
  if (const auto* text = std::get_if<std::string>(&entry)) return add_text(*text, hash);
  if (const auto* numbers = std::get_if<std::vector<double>>(&entry)) {
    hash.add(static_cast<std::uint64_t>(numbers->size()));
    for (const double x : *numbers) hash.add(x);
    return;
  }
  const auto& integers = std::get<std::vector<std::int64_t>>(entry);
  hash.add(static_cast<std::uint64_t>(integers.size()));
  for (const std::int64_t n : integers) hash.add(static_cast<std::uint64_t>(n));
}

/// Checksum over all entries: HDF5 detects a truncated file, but not a changed byte.
std::int64_t checksum(const State& state) {
  StateHash hash;
  for (const auto& [name, entry] : state.entries) {
    add_text(name, hash);
    add_entry(entry, hash);
  }
  return static_cast<std::int64_t>(hash.value());
}

/// Adds the groups above an entry, which must exist before it.
void add_groups(const std::string& name, std::set<std::string>& known, hdf5::Hdf5Writer& file) {
  for (std::size_t end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1))
    if (known.insert(name.substr(0, end)).second) file.add_group(name.substr(0, end));
}

StateEntry read_entry(const hdf5::Hdf5Reader& file, const std::string& name) {
  switch (file.kind(name)) {
    case hdf5::Hdf5Reader::Kind::numbers:
      return file.exact_numbers(name);
    case hdf5::Hdf5Reader::Kind::integers:
      return file.wide_integers(name);
    case hdf5::Hdf5Reader::Kind::text:
      return file.text(name);
    case hdf5::Hdf5Reader::Kind::other:
      break;
  }
  file.refuse(name, "holds no numbers and no text");
}

void demand_origin(const hdf5::Hdf5Reader& file, const std::string& path, const CheckpointOrigin& origin) {
  if (file.text("format") != k_format) throw InputError(path + ": is no checkpoint of Nilas");
  if (const int version = file.integer("version"); version != k_checkpoint_version)
    throw InputError(path + ": is a checkpoint of version " + std::to_string(version) +
                     ", this program reads version " + std::to_string(k_checkpoint_version) + " only");
  if (const std::string program = file.text("program"); program != origin.program)
    throw InputError(path + ": was written by " + program + "; this is " + origin.program +
                     ", which might not give the same bits");
  if (const std::string build = file.text("build_sha256"); build != origin.build)
    throw InputError(path + ": was written by another build of the same version (the program's SHA-256 was " + build +
                     ", is " + origin.build + "), which might not give the same bits");
  if (file.text("scene_sha256") != origin.scene)
    throw InputError(path + ": belongs to another scene than the scene.xml beside it, or that has changed");
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const CheckpointOrigin& origin, const State& state) {
  hdf5::Hdf5Writer file;
  file.add("format", std::string(k_format));
  file.add("version", std::vector<int>{k_checkpoint_version});
  file.add("program", origin.program);
  file.add("build_sha256", origin.build);
  file.add("scene_sha256", origin.scene);
  file.add("checksum", std::vector<std::int64_t>{checksum(state)});
  std::set<std::string> groups;
  for (const auto& [name, entry] : state.entries) {
    add_groups(k_group + name, groups, file);
    const std::string place = k_group + name;
    std::visit([&](const auto& values) { file.add(place, values); }, entry);
  }
  file.save(path, true);
}

State read_checkpoint(const std::filesystem::path& path, const CheckpointOrigin& origin) {
  const hdf5::Hdf5Reader file(path);
  demand_origin(file, path.string(), origin);
  State state;
  state.source = path.string();
  for (const auto& name : file.datasets("state")) state.entries.emplace(name, read_entry(file, k_group + name));
  if (file.wide_integers("checksum") != std::vector<std::int64_t>{checksum(state)})
    throw InputError(path.string() + ": is damaged: its checksum is not that of its content");
  return state;
}

}  // namespace nilas::sim
